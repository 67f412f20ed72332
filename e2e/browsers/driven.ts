import { writeFile } from 'node:fs/promises';
import { findOtherBrowsers } from '@farol/tools/findOtherBrowsers';
import { expect, test as base } from '@playwright/test';
import type { DrivenPage, InputAction } from './drive/DrivenPage';
import { driveFirefox } from './drive/firefox';
import { driveWebKit } from './drive/webkit';

export { expect } from '@playwright/test';

/** Names of keys by WebDriver's code points. @see https://www.w3.org/TR/webdriver2/#keyboard-actions */
const keys: Record<string, string | undefined> = {
  Control: '\uE009',
  Shift: '\uE008',
  Enter: '\uE007',
  Escape: '\uE00C',
  Tab: '\uE004',
  Delete: '\uE017',
  ArrowRight: '\uE014',
};

export interface Point {
  readonly x: number;
  readonly y: number;
}

/** A page of another browser, with the calls that Playwright's page has for Chromium. */
export class Driven {
  private readonly problems: string[] = [];

  constructor(private readonly page: DrivenPage) {}

  get browser(): string {
    return this.page.browser;
  }

  async open(url: string): Promise<void> {
    await this.keepProblems();
    await this.page.open(url);
  }

  /** What went wrong in the pages since the last call. */
  async takeProblems(): Promise<string[]> {
    await this.keepProblems();
    return this.problems.splice(0);
  }

  /** Calls a function in the page. Its argument and result are JSON; numbers that JSON lacks come as their names. */
  async evaluate<R, A = undefined>(body: (argument: A) => R | Promise<R>, argument?: A): Promise<R> {
    const text = `async (argument) => JSON.stringify(
      await (${body})(argument === 'undefined' ? undefined : JSON.parse(argument)),
      (_, value) => typeof value === 'number' && !Number.isFinite(value) ? String(value) : value) ?? 'null'`;
    return JSON.parse(await this.page.call(text, JSON.stringify(argument) ?? 'undefined')) as R;
  }

  /** Waits until a function of the page gives true. */
  async until<A = undefined>(body: (argument: A) => unknown, argument?: A): Promise<void> {
    await expect.poll(async () => Boolean(await this.evaluate(body, argument)), String(body)).toBe(true);
  }

  /** Middle of the first visible element that a selector finds, of those with a text where that is given, once it lies still. */
  async middleOf(selector: string, text?: string): Promise<Point> {
    let point: Point | null = null;
    const isStill = async (): Promise<boolean> => {
      const before = point;
      point = await this.evaluate(
        ([selector, text]) => {
          const all = [...document.querySelectorAll<HTMLElement>(selector)];
          const named = all.filter((each) => text === null || each.textContent.trim() === text);
          const found = named.find((each) => each.checkVisibility());
          found?.scrollIntoView({ block: 'nearest' });
          const box = found?.getBoundingClientRect();
          return box ? { x: Math.round(box.x + box.width / 2), y: Math.round(box.y + box.height / 2) } : null;
        },
        [selector, text ?? null] as const,
      );
      return before !== null && point !== null && before.x === point.x && before.y === point.y;
    };
    await expect.poll(isStill, `${selector} ${text ?? ''}`).toBe(true);
    return point!;
  }

  async click(selector: string, text?: string): Promise<void> {
    await this.clickAt(await this.middleOf(selector, text));
  }

  clickAt({ x, y }: Point): Promise<void> {
    return this.pointer([
      { type: 'pointerMove', x, y },
      { type: 'pointerDown', button: 0 },
      { type: 'pointerUp', button: 0 },
    ]);
  }

  hover({ x, y }: Point): Promise<void> {
    return this.pointer([{ type: 'pointerMove', x, y }]);
  }

  /** Drags in `steps` moves. */
  async drag(from: Point, to: Point, steps = 6): Promise<void> {
    const moves = Array.from({ length: steps }, (_, i): InputAction => {
      const t = (i + 1) / steps;
      const [x, y] = [from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t].map(Math.round);
      return { type: 'pointerMove', x, y, duration: 16 };
    });
    await this.pointer([
      { type: 'pointerMove', ...from },
      { type: 'pointerDown', button: 0 },
      ...moves,
      { type: 'pointerUp', button: 0 },
    ]);
  }

  wheel({ x, y }: Point, deltaY: number): Promise<void> {
    const actions = [{ type: 'scroll', x, y, deltaX: 0, deltaY }] as const;
    return this.page.perform([{ type: 'wheel', id: 'wheel', actions }]);
  }

  /** Presses keys together: 'Control+Shift+z'. */
  press(chord: string): Promise<void> {
    const values = chord.split('+').map((key) => keys[key] ?? key);
    return this.keyboard([
      ...values.map((value) => ({ type: 'keyDown' as const, value })),
      ...values.toReversed().map((value) => ({ type: 'keyUp' as const, value })),
    ]);
  }

  type(text: string): Promise<void> {
    return this.keyboard(
      [...text].flatMap((value) => [
        { type: 'keyDown' as const, value },
        { type: 'keyUp' as const, value },
      ]),
    );
  }

  async screenshot(path: string): Promise<void> {
    await writeFile(path, Buffer.from(await this.page.screenshot(), 'base64'));
  }

  /** Takes what the page has kept, before another one is opened. */
  private async keepProblems(): Promise<void> {
    this.problems.push(...(await this.evaluate(() => window.problems?.splice(0) ?? [])));
  }

  private pointer(actions: readonly InputAction[]): Promise<void> {
    return this.page.perform([{ type: 'pointer', id: 'mouse', actions }]);
  }

  private keyboard(actions: readonly InputAction[]): Promise<void> {
    return this.page.perform([{ type: 'key', id: 'keyboard', actions }]);
  }
}

/** Rows of the table that `npm run browsers` prints: a test says in annotations of this type how it went. */
export const FOUND = 'found';

/** Playwright's `test` with a page of the browser that the project is named after. Console errors and page errors fail it. */
export const test = base.extend<{ driven: Driven; found: (text: string) => void }, { opened: Driven }>({
  opened: [
    // oxlint-disable-next-line no-empty-pattern -- Playwright reads the names of the fixtures from the pattern
    async ({}, use, { project }) => {
      const { firefox, webkit, xvfb } = findOtherBrowsers();
      const page = project.name === 'firefox' ? await driveFirefox(firefox!, xvfb) : await driveWebKit(webkit!, xvfb);
      await use(new Driven(page));
      await page.close();
    },
    { scope: 'worker', timeout: 120_000 },
  ],

  driven: async ({ opened }, use, info) => {
    info.annotations.push({ type: 'browser', description: opened.browser });
    await use(opened);
    if (info.status !== info.expectedStatus) await opened.screenshot(info.outputPath('page.png'));
    expect(await opened.takeProblems(), 'console errors and errors of the page').toEqual([]);
  },

  // oxlint-disable-next-line no-empty-pattern -- as above
  found: async ({}, use, info) => use((description) => void info.annotations.push({ type: FOUND, description })),
});
