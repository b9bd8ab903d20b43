/** Promises whose outcome is decided elsewhere. */

/** {promise, resolve, reject}; a rejection that nobody awaits is no error by itself: whoever awaits it hears of it, and nobody has to. */
export function makeDeferred() {
  const deferred = {};
  deferred.promise = new Promise((resolve, reject) => Object.assign(deferred, { resolve, reject }));
  deferred.promise.catch(() => {});
  return deferred;
}

/** Those who wait for the same moment. */
export class Waiting {
  #waiting = [];

  get any() {
    return this.#waiting.length > 0;
  }
  /** A promise for the next time. */
  join() {
    return new Promise((resolve, reject) => this.#waiting.push({ resolve, reject }));
  }
  resolve() {
    for (const { resolve } of this.#waiting.splice(0)) resolve();
  }
  reject(error) {
    for (const { reject } of this.#waiting.splice(0)) reject(error);
  }
}
