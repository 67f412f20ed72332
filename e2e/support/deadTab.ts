import type { Page } from '@playwright/test';

/** A tab that is reached past Playwright, which gives a page up once it has crashed. */
export interface DeadTab {
  /**
   * Ends the processes of the browser's pages, as "Exit page" does with one that hangs; then loads this tab's address anew.
   * A page that hangs does not hear of `Page.crash` in time.
   */
  killAndReload(): Promise<void>;
  /** The value of an expression in the page, as JSON; undefined while it throws, and while a page is loading. */
  evaluate(expression: string): Promise<unknown>;
}

interface Answer {
  readonly id?: number;
  readonly result?: { readonly result?: { readonly value?: unknown } };
}

/** Handle of a tab that will be killed; to be made while the page still answers. */
export async function deadTabOf(page: Page): Promise<DeadTab> {
  const own = await page.context().newCDPSession(page);
  const { targetInfo } = await own.send('Target.getTargetInfo');
  const browser = await page.context().browser()!.newBrowserCDPSession();
  const { targetId } = targetInfo;
  const { sessionId } = await browser.send('Target.attachToTarget', { targetId, flatten: false });
  const waiting = new Map<number, (answer: Answer) => void>();
  browser.on('Target.receivedMessageFromTarget', ({ message }) => {
    const answer = JSON.parse(message) as Answer;
    if (answer.id !== undefined) waiting.get(answer.id)?.(answer);
  });
  let sent = 0;
  const send = (method: string, params: object = {}): Promise<Answer> =>
    new Promise((resolve) => {
      const id = ++sent;
      waiting.set(id, resolve);
      const message = JSON.stringify({ id, method, params });
      void browser.send('Target.sendMessageToTarget', { sessionId, message });
    });
  return {
    async killAndReload() {
      const crashed = page.waitForEvent('crash');
      const { processInfo } = await browser.send('SystemInfo.getProcessInfo');
      for (const { id, type } of processInfo) if (type === 'renderer') process.kill(id, 'SIGKILL');
      await crashed;
      await send('Page.reload');
    },
    async evaluate(expression) {
      const { result } = await send('Runtime.evaluate', { expression, returnByValue: true, awaitPromise: true });
      return result?.result?.value;
    },
  };
}
