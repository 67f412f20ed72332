import { spawn } from 'node:child_process';
import { createServer } from 'node:net';
import { expect } from '@playwright/test';
import { type DrivenPage, endAll, PAGE, startSurroundings } from './DrivenPage';

export interface WebKitPaths {
  readonly driver: string;
  readonly browser: string;
}

/** A port of this machine that nothing listens at. */
const freePort = (): Promise<number> =>
  new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address() as { port: number };
      server.close(() => resolve(port));
    });
  });

/** Starts WebKitGTK's MiniBrowser and drives it by WebDriver. @see https://www.w3.org/TR/webdriver2/ */
export async function driveWebKit({ driver, browser }: WebKitPaths, xvfb: string | null): Promise<DrivenPage> {
  const { env, children } = await startSurroundings(xvfb);
  const port = await freePort();
  const child = spawn(driver, [`--port=${port}`, '--host=127.0.0.1'], { env, stdio: 'ignore' });
  children.push(child);
  const send = async (method: string, path: string, body?: object): Promise<unknown> => {
    const answer = await fetch(`http://127.0.0.1:${port}${path}`, { method, body: body && JSON.stringify(body) });
    const { value } = (await answer.json()) as { value: { error?: string; message?: string } };
    if (!answer.ok) throw new Error(`${path}: ${value.error}: ${value.message}`);
    return value;
  };
  await expect(() => send('GET', '/status')).toPass();
  const args = ['--automation'];
  const made = (await send('POST', '/session', {
    capabilities: { alwaysMatch: { 'webkitgtk:browserOptions': { binary: browser, args } } },
  })) as { sessionId: string; capabilities: { browserVersion: string } };
  const session = `/session/${made.sessionId}`;
  await send('POST', `${session}/timeouts`, { script: 280_000, pageLoad: 280_000 });

  /** Makes the window so large that the page has its size. */
  const fit = async (): Promise<void> => {
    const size = 'return [innerWidth, innerHeight]';
    const { width, height } = (await send('GET', `${session}/window/rect`)) as typeof PAGE;
    const [inner, tall] = (await send('POST', `${session}/execute/sync`, { script: size, args: [] })) as number[];
    const rect = { x: 0, y: 0, width: width + PAGE.width - inner, height: height + PAGE.height - tall };
    await send('POST', `${session}/window/rect`, rect);
  };

  return {
    browser: `WebKitGTK ${made.capabilities.browserVersion}`,
    async open(url) {
      await send('POST', `${session}/url`, { url });
      await fit();
    },
    async call(functionText, argument) {
      const script = `const [argument, done] = arguments;
        Promise.resolve(argument).then(${functionText}).then((value) => done([value]), (error) => done([null, String(error?.stack ? error + '\\n' + error.stack : error)]))`;
      const [value, failure] = (await send('POST', `${session}/execute/async`, {
        script,
        args: [argument],
      })) as string[];
      if (failure) throw new Error(failure);
      return value ?? 'null';
    },
    async perform(sources) {
      await send('POST', `${session}/actions`, { actions: sources });
    },
    async screenshot() {
      return (await send('GET', `${session}/screenshot`)) as string;
    },
    async close() {
      await send('DELETE', session);
      await endAll(children);
    },
  };
}
