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
