import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { clocksIn } from './clocks.mjs';
import { root } from './root.mjs';
import { filesEnding } from './sourceFiles.mjs';

describe('tests use no time', () => {
  it('in any file: wait for the thing itself, count work (workOf), or move the test to verify', () => {
    const files = filesEnding('.ts', '.tsx').filter(
      (path) => /\.(test|spec)\.tsx?$/.test(path) || (path.startsWith('e2e/') && !path.startsWith('e2e/pages/')),
    );
    expect(files.length).toBeGreaterThan(450);
    expect(files.flatMap((path) => clocksIn(path, readFileSync(join(root, path), 'utf8')))).toEqual([]);
  });

  it.each([
    'const begin = performance.now();',
    'const begin = window.performance.now();',
    'const begin = Date.now();',
    'const begin = new Date();',
    'await new Promise((resolve) => setTimeout(resolve, 100));',
    'const end = window.setInterval(look, 10);',
    'await page.waitForTimeout(10);',
    'const begin = process.hrtime.bigint();',
    'const { user } = process.cpuUsage();',
    'requestAnimationFrame(() => requestAnimationFrame(() => resolve()));',
    'for (let i = 0; i < 5; i++) await new Promise(requestAnimationFrame);',
    'const next = () => new Promise(requestAnimationFrame); for (let i = 0; i < 5; i++) { draw(); await next(); }',
    'const frame = () => { if (++frames < 6) return requestAnimationFrame(frame); done(); };',
    "test('a', async () => { await page.evaluate(() => performance.now()); });",
  ])('as in %s', (source) => {
    expect(clocksIn('e2e/a.spec.ts', source)).toHaveLength(1);
    expect(clocksIn('packages/a.verify.test.ts', source)).toEqual([]);
    expect(clocksIn('e2e/a.long.ts', source)).toEqual([]);
    expect(clocksIn('e2e/a.spec.ts', `test('long @verify', async () => { ${source} });`)).toEqual([]);
    expect(clocksIn('e2e/a.spec.ts', `test('times @long', async () => { ${source} });`)).toEqual([]);
    expect(clocksIn('e2e/a.spec.ts', `test('long', { tag: '@verify' }, async () => { ${source} });`)).toEqual([]);
  });

  it.each([
    "vi.spyOn(performance, 'now').mockImplementation(() => now++);",
    'vi.useFakeTimers(); vi.advanceTimersByTime(100);',
    'test.setTimeout(240_000);',
    'const day = new Date(2026, 0, 31);',
    "// performance.now()\nconst text = 'await page.waitForTimeout(10)';",
    'while (!example.farol) await new Promise(requestAnimationFrame);',
    'for (let i = 0; i < 5; i++) farol.render(scene, camera);',
  ])('unlike %s', (source) => {
    expect(clocksIn('e2e/a.spec.ts', source)).toEqual([]);
  });

  it('is told by file and line', () => {
    expect(clocksIn('p/a.test.ts', 'let a;\n\na = Date.now();')).toEqual(['p/a.test.ts:3 Date.now']);
  });
});
