import { expect, test } from 'vitest';
import { needsPackage } from './needsPackage';

test('gives the code, or a sentence that names the package, what needs it and the mend', async () => {
  await expect(needsPackage('sucrase', 'Scripts need', Promise.resolve(7))).resolves.toBe(7);
  const cause = new TypeError('Failed to resolve module specifier "sucrase"');
  const failed = needsPackage('sucrase', 'Scripts need', Promise.reject(cause));
  await expect(failed).rejects.toThrow(/^Scripts need the package sucrase, .* \(npm install sucrase\)/);
  await expect(failed).rejects.toMatchObject({ cause });
});
