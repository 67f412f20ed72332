import type { Page } from '@playwright/test';

/** Loses the context of a page's only WebGL canvas and has it restored; `canvas` is an expression in the page. */
export async function loseContext(page: Page, canvas: string): Promise<void> {
  // a lost context gives no extension any more
  const loser = await page.evaluateHandle((canvas) => {
    // oxlint-disable-next-line no-eval -- an expression of the test's own
    const element = (0, eval)(canvas) as HTMLCanvasElement;
    return { element, extension: element.getContext('webgl2')!.getExtension('WEBGL_lose_context')! };
  }, canvas);
  // each in a task of its own: WebGL restores no context in the task that tells of its loss
  for (const [act, event] of [
    ['loseContext', 'webglcontextlost'],
    ['restoreContext', 'webglcontextrestored'],
  ] as const) {
    await loser.evaluate(
      async ({ element, extension }, [act, event]) => {
        const done = new Promise((resolve) => element.addEventListener(event, resolve, { once: true }));
        extension[act]();
        await done;
      },
      [act, event] as const,
    );
  }
  await loser.dispose();
}
