import { followEverySecond } from "./support/follow.mjs";

followEverySecond(0);
