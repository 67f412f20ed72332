import { sourceFiles } from '@farol/tools/sourceFiles';
import { tableOf } from '@farol/tools/texts';
import { expect, test } from '../support/test';
import { openEditor, serialized, waitUntilReady } from './editor';

test.use({ locale: 'es-ES' });

/** English texts that are another in Spanish, and no Spanish text by chance. */
function englishTexts(): Set<string> {
  const texts = [...sourceFiles()]
    .filter(([path]) => path.startsWith('apps/editor/src/language/es/'))
    .flatMap(([path, source]) => Object.entries(tableOf(path, source)));
  const spanish = new Set(texts.map(([, text]) => text));
  return new Set(texts.map(([english]) => english).filter((english) => !spanish.has(english)));
}

test('in a Spanish browser the editor speaks Spanish; in English the scene and the selection stay', async ({
  page,
}) => {
  await openEditor(page, 'empty');
  await expect(page.locator('html')).toHaveAttribute('lang', 'es');
  await page.getByRole('treeitem', { name: 'Sol' }).click();
  await expect(page.getByRole('textbox', { name: 'Intensidad' })).toBeVisible();
  const shown = await page.evaluate(() => {
    // names of passes and of assets are the same in all languages
    const isShown = (element: Element | null) =>
      element?.checkVisibility() && !element.closest('.status-passes, .asset-card');
    const texts = [...document.querySelectorAll('[aria-label], [title], [placeholder]')]
      .filter(isShown)
      .flatMap((element) => ['aria-label', 'title', 'placeholder'].map((name) => element.getAttribute(name) ?? ''));
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode())
      if (isShown(walker.currentNode.parentElement)) texts.push(walker.currentNode.nodeValue ?? '');
    return texts.map((text) => text.trim());
  });
  expect(shown.length).toBeGreaterThan(100);
  const english = englishTexts();
  expect(english.size).toBeGreaterThan(500);
  expect(shown.filter((text) => english.has(text))).toEqual([]);

  const before = await serialized(page);
  await page.getByRole('menuitem', { name: 'Ayuda' }).click();
  await page.getByRole('menuitem', { name: 'Idioma' }).press('ArrowRight');
  await page.getByRole('menuitemcheckbox', { name: 'English' }).click();
  await expect(page.getByRole('textbox', { name: 'Intensity' })).toBeVisible();
  await expect(page.getByRole('treeitem', { name: 'Sol' })).toHaveAttribute('aria-selected', 'true');
  expect(await serialized(page)).toBe(before);
  // chosen once, it is remembered
  await page.reload();
  await waitUntilReady(page);
  await expect(page.locator('html')).toHaveAttribute('lang', 'en');
  await expect(page.getByRole('tab', { name: 'Hierarchy' })).toBeVisible();
});

test('why a technique was chosen is told in Spanish @verify', async ({ page }) => {
  await openEditor(page, 'empty');
  await page.getByRole('tab', { name: 'Fotograma' }).click();
  const frame = page.getByRole('region', { name: 'Fotograma' });
  await expect(frame.getByLabel('Por qué esta técnica')).toHaveText(
    'Forward, una pasada: casi ninguna luz: las listas costarían más de lo que ahorran.',
  );
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('menus fit the window, and the handles of what is selected too', async ({ page }) => {
    await openEditor(page, 'empty');
    await page.getByRole('button', { name: 'Menús' }).tap();
    await page.getByRole('menuitem', { name: 'Vista', exact: true }).tap();
    await expect(page.getByRole('menuitem', { name: 'Mirar desde' })).toBeVisible();
    for (const menu of await page.getByRole('menu').all()) {
      const { x, width } = (await menu.boundingBox())!;
      expect(x).toBeGreaterThanOrEqual(0);
      expect(x + width).toBeLessThanOrEqual(390);
    }
    // nothing made the page wider
    expect(await page.evaluate(() => window.innerWidth)).toBe(390);
    await page.keyboard.press('Escape');
    await page.keyboard.press('Escape');

    await page.getByRole('button', { name: 'Añadir', exact: true }).tap();
    await page.getByRole('menuitem', { name: 'Malla', exact: true }).tap();
    await page.getByRole('menuitem', { name: 'Esfera', exact: true }).tap();
    /** How long the arrow that goes up is, in shares of the width of the picture. */
    const arrow = (): Promise<number> =>
      page.evaluate(() => {
        const { gizmo, editorCamera, canvas } = window.editor.viewport;
        const { camera } = editorCamera;
        const handle = gizmo.three.getObjectByName('Y');
        if (!handle) return 0;
        const tip = handle.position.clone().setY(handle.position.y + handle.scale.y / 2);
        const length = tip.project(camera).y - handle.position.clone().project(camera).y;
        return (length / 2) * (canvas.clientHeight / canvas.clientWidth);
      });
    await expect.poll(arrow).toBeGreaterThan(0.1);
    expect(await arrow()).toBeLessThan(0.3);
  });
});
