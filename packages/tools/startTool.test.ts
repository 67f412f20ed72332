import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, expect, it } from 'vitest';

const folder = mkdtempSync(join(tmpdir(), 'farol-start-'));
afterAll(() => rmSync(folder, { recursive: true }));

/**
 * Starts a process that runs a script with its output held.
 *
 * @param script - text of the script
 * @returns its output; `until` waits for a text in it
 */
function holding(script: string) {
  const path = join(folder, 'script.mjs');
  writeFileSync(path, script);
  const parent = spawn(
    process.execPath,
    [
      '--input-type=module',
      '-e',
      `import { endWithScripts, startScript } from ${JSON.stringify(new URL('startTool.mjs', import.meta.url).href)};
      endWithScripts();
      process.exitCode = await startScript(${JSON.stringify(path)}, [], { isHeld: true });`,
    ],
    { stdio: ['ignore', 'pipe', 'inherit'] },
  );
  let output = '';
  const ended = new Promise<number | null>((resolve) => parent.on('close', resolve));
  const heard: (() => void)[] = [];
  parent.stdout.on('data', (part) => {
    output += part;
    for (const look of heard) look();
  });
  return {
    parent,
    ended,
    output: () => output,
    until: (text: string) => new Promise<void>((resolve) => heard.push(() => output.includes(text) && resolve())),
  };
}

const RUNS_ON = 'setInterval(() => {}, 1000)';

it('is shown in one piece at the end, but for failed tests', async () => {
  const { output, ended } = holding(`console.log('  ✓  1 good\\n  ✘  2 bad'); process.exit(3);`);
  expect(await ended).toBe(3);
  expect(output()).toBe('  ✘  2 bad\n  ✓  1 good\n  ✘  2 bad\n');
});

it('what is told to end shows what its scripts had said, and what they say of it', async () => {
  const { parent, until, output, ended } = holding(
    `process.on('SIGINT', () => { console.log('running: slow'); process.exit(1); });
    console.log('quiet'); console.log('  ✘  2 bad'); ${RUNS_ON}`,
  );
  await until('bad');
  expect(output()).not.toContain('quiet');
  parent.kill('SIGTERM');
  expect(await ended).toBe(143);
  expect(output()).toMatch(/Ended by SIGTERM.*\nquiet\n.*bad\nrunning: slow\n$/s);
});
