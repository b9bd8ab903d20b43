import { followEverySecond } from "./support/follow.mjs";

followEverySecond(1);
