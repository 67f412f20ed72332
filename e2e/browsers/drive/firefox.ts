import { spawn } from 'node:child_process';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import WebSocket from 'ws';
import { type DrivenPage, endAll, lineOf, PAGE, startSurroundings } from './DrivenPage';

/** Preferences of the profile: WebGL by the software rasteriser as well, no traffic and no pages of Firefox's own. */
const preferences = {
  'webgl.force-enabled': true,
  'browser.shell.checkDefaultBrowser': false,
  'browser.startup.homepage_override.mstone': 'ignore',
  'datareporting.policy.dataSubmissionEnabled': false,
  'app.update.disabledForTesting': true,
  'network.captive-portal-service.enabled': false,
  'network.connectivity-service.enabled': false,
  'services.settings.server': 'data:,#remote-settings-dummy/v1',
  'dom.max_script_run_time': 0,
  // a long frame of the software rasteriser is no hang
  'dom.ipc.processHangMonitor': false,
};

/** Fields of an answer of BiDi that are read here; events have no `id`. */
interface Message {
  readonly id?: number;
  readonly error?: string;
  readonly message?: string;
  readonly result?: Record<string, unknown>;
}

/** Result of `script.callFunction`. */
interface Called {
  readonly type: 'success' | 'exception';
  readonly result?: { readonly value: string };
  readonly exceptionDetails?: { readonly text: string };
}

/** Starts Firefox, and drives it by WebDriver BiDi. @see https://www.w3.org/TR/webdriver-bidi/ */
export async function driveFirefox(path: string, xvfb: string | null): Promise<DrivenPage> {
  const profile = await mkdtemp(join(tmpdir(), 'farol-firefox-'));
  const lines = Object.entries(preferences).map(([name, value]) => `user_pref("${name}", ${JSON.stringify(value)});`);
  await writeFile(join(profile, 'user.js'), lines.join('\n'));
  const { env, children } = await startSurroundings(xvfb);
  const child = spawn(path, ['--no-remote', '--profile', profile, '--remote-debugging-port', '0'], {
    env,
    stdio: ['ignore', 'ignore', 'pipe'],
  });
  children.push(child);
  const [, address] = await lineOf(child, child.stderr, /WebDriver BiDi listening on (ws:\S+)/);
  const socket = new WebSocket(`${address}/session`, { maxPayload: 2 ** 30 });
  await new Promise((resolve, reject) => socket.once('open', resolve).once('error', reject));

  const waiting = new Map<number, (message: Message) => void>();
  socket.on('message', (data: Buffer) => {
    const message = JSON.parse(data.toString()) as Message;
    if (message.id !== undefined) waiting.get(message.id)?.(message);
  });
  let count = 0;
  const send = (method: string, params: object): Promise<Record<string, unknown>> =>
    new Promise((resolve, reject) => {
      const id = ++count;
      waiting.set(id, ({ error, message, result = {} }) => {
        waiting.delete(id);
        if (error) reject(new Error(`${method}: ${error}: ${message}`));
        else resolve(result);
      });
      socket.send(JSON.stringify({ id, method, params }));
    });

  const { capabilities } = await send('session.new', { capabilities: {} });
  const { browserVersion } = capabilities as { browserVersion: string };
  const { contexts } = await send('browsingContext.getTree', {});
  const [{ context }] = contexts as { context: string }[];
  await send('browsingContext.setViewport', { context, viewport: PAGE });

  return {
    browser: `Firefox ${browserVersion}`,
    async open(url) {
      await send('browsingContext.navigate', { context, url, wait: 'complete' });
    },
    async call(functionText, argument) {
      const called = (await send('script.callFunction', {
        functionDeclaration: functionText,
        awaitPromise: true,
        target: { context },
        arguments: [{ type: 'string', value: argument }],
        userActivation: true,
      })) as unknown as Called;
      if (called.type === 'exception') throw new Error(called.exceptionDetails?.text);
      return called.result?.value ?? 'null';
    },
    async perform(sources) {
      await send('input.performActions', { context, actions: sources });
    },
    async screenshot() {
      const { data } = await send('browsingContext.captureScreenshot', { context });
      return data as string;
    },
    async close() {
      socket.close();
      await endAll(children);
      await rm(profile, { recursive: true, force: true });
    },
  };
}
