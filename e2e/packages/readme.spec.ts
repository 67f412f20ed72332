import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '@farol/tools/root';
import { expect, test } from '@playwright/test';
import { installed } from './installed';

test("README's two commands pack Farol in a clone and install it beside @verify", () => {
  const [, section] = readFileSync(join(root, 'README.md'), 'utf8').split('## In your own page');
  const commands = /```sh\n([^`]+)```/.exec(section)![1].trimEnd().split('\n');
  expect(commands).toHaveLength(2);

  const { host, repositoryModules } = installed();
  const page = join(host, '../readme/page');
  mkdirSync(page, { recursive: true });
  symlinkSync(root, join(page, '../farol'), 'junction');
  writeFileSync(join(page, 'package.json'), '{"private":true,"type":"module"}');
  const run = (command: string): string => {
    const { status, stdout, stderr } = spawnSync(command, { cwd: page, shell: true, encoding: 'utf8' });
    expect(status, `${command}\n${stdout}${stderr}`).toBe(0);
    return stdout;
  };
  // three as the repository has it: its newest version would have to be asked of the registry
  const three = JSON.stringify(join(repositoryModules, 'three'));
  for (const command of commands) run(command.replace(/#.*/, '').replace(/ three\b/, ` ${three}`));
  expect(run(`node -e "import('@farol/renderer').then((all) => console.log(typeof all.FarolRenderer))"`)).toBe(
    'function\n',
  );
});
