import type { Page } from '@playwright/test';
import { testWithSharedPage } from '../support/sharedPage';
import { openViewer, still } from '../support/viewer';

export { expect } from '../support/sharedPage';

/** The parts of `window.viewer` that are put back between tests; documented in apps/viewer/src/main.ts. */
interface Kept {
  readonly messages: { show(subject: string, text: string): void };
  setGui(shown: boolean): void;
  setTime(seconds: number): void;
}

/** Puts the viewer back to how it opens by the address of `still`, and shows the menu. */
const reset = (page: Page): Promise<void> =>
  page.evaluate(async ({ scene, n, m, time }) => {
    const viewer = window.viewer as typeof window.viewer & Kept;
    for (const { dataset } of document.querySelectorAll<HTMLElement>('.message'))
      viewer.messages.show(dataset.subject!, '');
    viewer.setTechnique('deferred');
    viewer.setView('final');
    await viewer.loadScene(scene, { n, m });
    viewer.setTime(time);
    viewer.setGui(true);
  }, still);

/** `test` with a viewer that shows a small scene, which stands still, and its menu; it opens once for the tests of a worker. */
export const test = testWithSharedPage('viewer', (page) => openViewer(page, { ...still, gui: 1 }), reset);
