import type { Page } from '@playwright/test';

/** Takes float colour targets away from the contexts of a page, as on some devices; to be called before it is opened. */
export async function hideFloatTargets(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const { prototype } = WebGL2RenderingContext;
    const { getExtension } = prototype;
    prototype.getExtension = function (this: WebGL2RenderingContext, name: string) {
      return /color_buffer_(half_)?float|float_blend/.test(name)
        ? null
        : (getExtension.call(this, name as never) as unknown);
    } as typeof getExtension;
  });
}
