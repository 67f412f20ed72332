import type { Page } from '@playwright/test';

/** Loses the context of a page's only WebGL canvas and has it restored; `canvas` is an expression in the page. */
export async function loseContext(page: Page, canvas: string): Promise<void> {
  await page.evaluate(async (canvas) => {
    // oxlint-disable-next-line no-eval -- an expression of the test's own
    const element = (0, eval)(canvas) as HTMLCanvasElement;
    const extension = element.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
    const event = (name: string) => new Promise((resolve) => element.addEventListener(name, resolve, { once: true }));
    const lost = event('webglcontextlost');
    extension.loseContext();
    await lost;
    const restored = event('webglcontextrestored');
    setTimeout(() => extension.restoreContext());
    await restored;
  }, canvas);
}
