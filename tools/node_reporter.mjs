// A reporter for `node --test`: one JSON object a line for each test that ended, for tools/test.py to count. A suite
// (describe) is no test, but one that is skipped hides its tests, so it is told. left: skipped, or left to do; why: what it
// failed of, in one line.

const kMostOfReason = 200; // characters

export default async function* report(source) {
  for await (const { type, data } of source) {
    if (type !== 'test:pass' && type !== 'test:fail') continue;
    const left = data.skip !== undefined || data.todo !== undefined;
    if (data.details?.type === 'suite' && !left) continue;
    const error = data.details?.error?.cause ?? data.details?.error;
    const why = type === 'test:fail' ? String(error?.message ?? error ?? '').replace(/\s+/g, ' ').trim().slice(0, kMostOfReason) : '';
    yield JSON.stringify({ name: data.name, passed: type === 'test:pass', left, why }) + '\n';
  }
}
