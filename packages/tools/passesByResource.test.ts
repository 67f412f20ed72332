import { describe, expect, it } from 'vitest';
import { sourceFiles } from './sourceFiles.mjs';

/** Folders whose code is to ask for what passes hand over, never for a pass. */
const FOLDERS = /^(packages\/renderer\/src\/(techniques|effects|adapters|lazy)|apps\/editor\/src\/plugins)\//;

/** Code that tells passes apart by class or name; passes are to be found by the resources that they write. */
const BY_CLASS = /\binstanceof\s+\w*Pass\b/;
const BY_NAME =
  /\bpass\.name\s*[!=]==?|[!=]==?\s*pass\.name\b|\bname\s*===?\s*['"](g-buffer|depth|output|transparent)['"]/i;

const asksForPass = (source: string): boolean => BY_CLASS.test(source) || BY_NAME.test(source);

describe('techniques, effects and plugins', () => {
  it('ask for resources, never for a class or a name of a pass', () => {
    const files = [...sourceFiles()].filter(([path]) => FOLDERS.test(path));
    expect(files.length).toBeGreaterThan(100);
    expect(files.filter(([, source]) => asksForPass(source)).map(([path]) => path)).toEqual([]);
  });

  it.each([
    ['if (pass instanceof GBufferPass) return;', true],
    ["if (pass.name === 'g-buffer') return;", true],
    ['effects.some(({ replaces }) => replaces === pass.name)', true],
    ["passes.some((each) => each.name === 'depth')", true],
    ['recorder.beginPass(pass.name);', false],
    ['if (error instanceof TwinRefusal) return;', false],
  ])('are told by %s: %s', (source, found) => {
    expect(asksForPass(source)).toBe(found);
  });
});
