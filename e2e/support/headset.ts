import { createRequire } from 'node:module';
import type { Locator, Page } from '@playwright/test';
import type { metaQuest3, XRDevice } from 'iwer';

/** Gives a page an emulated headset. Call it before the page is opened. */
export async function addHeadset(page: Page): Promise<void> {
  await page.addInitScript({ path: createRequire(import.meta.url).resolve('iwer/build/iwer.min.js') });
  await page.addInitScript(() => {
    const { IWER } = window as unknown as { IWER: { XRDevice: typeof XRDevice; metaQuest3: typeof metaQuest3 } };
    new IWER.XRDevice(IWER.metaQuest3).installRuntime({ forceInstall: true });
  });
}

/** Texts of pairs of elements that lie over each other, by the rectangles round them. */
export async function overlaps(elements: Locator): Promise<string[]> {
  const boxes = await elements.evaluateAll((all) =>
    all.map((each) => ({ text: each.textContent, box: each.getBoundingClientRect().toJSON() as DOMRect })),
  );
  return boxes.flatMap(({ text, box: a }, i) =>
    boxes
      .slice(i + 1)
      .filter(({ box: b }) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
      .map((other) => `${text} over ${other.text}`),
  );
}
