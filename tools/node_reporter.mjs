// A reporter for `node --test`: one JSON object a line for each test that ended, for tools/test.py to count. A suite
// (describe) is no test, but one that is skipped hides its tests, so it is told. left: skipped, or left to do.

export default async function* report(source) {
  for await (const { type, data } of source) {
    if (type !== 'test:pass' && type !== 'test:fail') continue;
    const left = data.skip !== undefined || data.todo !== undefined;
    if (data.details?.type === 'suite' && !left) continue;
    yield JSON.stringify({ name: data.name, passed: type === 'test:pass', left }) + '\n';
  }
}
