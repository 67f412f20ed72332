import { byExtent } from '@farol/tools/extent';
import { test as own } from '../support/test';
import { addObject, history, openEditor } from './editor';
import { expect, test } from './sharedEditor';

const options = { viewport: { width: 1100, height: 600 }, reducedMotion: 'reduce' } as const;
test.use(options);
own.use(options);

test('the palette finds what can be done, and does it', async ({ page }) => {
  const search = page.getByRole('combobox', { name: 'Search commands' });
  const options = page.getByRole('option');

  // a technique, by its name
  await page.keyboard.press('Control+k');
  await expect(search).toBeFocused();
  await page.keyboard.type('forw sing');
  await expect(options.first()).toContainText('Forward, single pass');
  await page.keyboard.press('Enter');
  await expect(search).toHaveCount(0);
  await expect.poll(() => page.evaluate(() => window.editor.viewport.technique)).toBe('forward-single-pass');

  // something to add, chosen by the arrow keys; while a text field has the focus
  await page.getByRole('textbox', { name: 'Name of the scene' }).focus();
  await page.keyboard.press('Control+k');
  await search.fill('light add');
  await expect(options.nth(1)).toBeVisible();
  const second = await options.nth(1).locator('.palette-label').textContent();
  await page.keyboard.press('ArrowDown');
  await expect(options.nth(1)).toHaveAttribute('aria-selected', 'true');
  await page.keyboard.press('Enter');
  await expect.poll(() => history(page).then((steps) => steps.at(-1))).toBe(`Added ${second}`);

  // an object; Escape closes
  await expect(search).toHaveCount(0);
  await page.keyboard.press('Control+k');
  await search.fill('sun');
  await options.filter({ hasText: 'Select' }).click();
  await expect
    .poll(() => page.evaluate(() => window.editor.document.selectedObjects.map(({ name }) => name)))
    .toEqual(['Sun']);
  await expect(search).toHaveCount(0);
  const sun = page.getByRole('treeitem', { name: 'Sun' });
  await sun.click();
  await page.keyboard.press('Control+k');
  await expect(search).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(search).toHaveCount(0);
  await expect(sun).toBeFocused();
});

own('keys are chosen anew, clashes are told, and all of it is remembered and reset', async ({ page }) => {
  await openEditor(page, 'empty');
  // letters typed before the palette's code is there and shown are kept
  const search = page.getByRole('combobox', { name: 'Search commands' });
  let typed = '';
  await page.keyboard.press('Control+k');
  do await page.keyboard.type((typed += 'dark ').slice(-5));
  while (!(await search.isVisible()));
  await expect(search).toHaveValue(typed);
  await expect(page.getByRole('option').first()).toContainText('Dark theme');
  await page.keyboard.press('Escape');
  const dialog = page.getByRole('dialog', { name: 'Keys' });
  const openKeys = async (): Promise<void> => {
    await page.getByRole('button', { name: 'Keys', exact: true }).click();
    await expect(dialog.getByRole('searchbox', { name: 'Search keys' })).toBeFocused();
  };
  await page.getByRole('treeitem', { name: 'Sun' }).click();
  await openKeys();
  await dialog.getByRole('searchbox', { name: 'Search keys' }).fill('duplicate');
  const row = dialog.locator('[data-action="edit.duplicate"]');

  // Escape ends listening, not the dialog; then a key that is another action's
  await row.getByRole('button', { name: 'Add a key' }).click();
  await page.keyboard.press('Escape');
  await expect(dialog).toBeVisible();
  await row.getByRole('button', { name: 'Add a key' }).click();
  await page.keyboard.press('h');
  await expect(row.getByRole('alert')).toContainText('“Hide”');
  await row.getByRole('button', { name: 'Take it over' }).click();
  await row.getByRole('button', { name: 'Take Ctrl+D from Duplicate' }).click();
  await expect(row.locator('kbd')).toHaveText(['H']);
  await dialog.getByRole('button', { name: 'Close' }).click();
  await expect(dialog).toHaveCount(0);

  await page.getByRole('treeitem', { name: 'Sun' }).first().focus();
  await page.keyboard.press('h');
  expect(await history(page)).toEqual(['Duplicated Sun']);
  await page.keyboard.press('Control+d');
  expect(await history(page)).toHaveLength(1);

  // nothing to recover
  await page.keyboard.press('Control+z');
  await expect.poll(() => page.evaluate(() => window.editor.autosave?.isUpToDate)).toBe(true);
  await page.reload();
  await page.waitForFunction(() => 'editor' in window);
  await page.evaluate(() => window.editor.ready);
  await openKeys();
  await expect(row.locator('kbd')).toHaveText(['H']);
  await expect(dialog.locator('[data-action="edit.hide"] kbd')).toHaveCount(0);
  await dialog.getByRole('button', { name: 'Reset all' }).click();
  await expect(row.locator('kbd')).toHaveText(['Ctrl+D']);
  await expect(dialog.locator('[data-action="edit.hide"] kbd')).toHaveText(['H']);
});

/** Actions that change more than the scene (files, windows, languages, plugins), undo itself, and playing, which puts everything back. */
const beyond = /^(file|help|play|plugins)\.|^edit\.(undo|redo)$|^panels\.|^view\.theme/;

test('whatever an action does to the scene is one step, undone and done again exactly', async ({ page }) => {
  await addObject(page, 'Mesh', 'Cone');
  // in the slice each by the first selection that enables it
  const most = byExtent({ slice: 1, verify: Infinity });
  const found = await page.evaluate(
    async ([pattern, most]) => {
      const left = new RegExp(pattern);
      interface Action {
        readonly id: string;
        run(editor: unknown): unknown;
        enabled?(editor: unknown): boolean;
      }
      const editor = window.editor as typeof window.editor & {
        readonly actions: { readonly list: readonly Action[]; get(id: string): Action | undefined };
        readonly commands: { undo(): void; redo(): void };
        readonly dialogs: { close(agreed: boolean): void };
        readonly tools: { end(): boolean };
      };
      const { document, actions, commands, dialogs, tools, viewport } = editor;
      // the picture is no subject here
      viewport.renderNow = () => {};
      const { scene, selection } = document;
      const run = async (id: string): Promise<void> => void (await actions.get(id)!.run(editor));
      const idOf = (name: string): string => scene.find(name)!.id;
      // a group of two, an instance of a prefab, a mesh and a camera
      selection.set([idOf('Sky')]);
      for (const id of ['edit.duplicate', 'edit.duplicate', 'prefab.make']) await run(id);
      const instance = selection.ids[0];
      selection.set([idOf('Sun'), idOf('Sky')]);
      await run('edit.group');
      const group = selection.ids[0];
      const selections = [[group], [instance], [idOf('Cone')], [idOf('Cone'), idOf('Camera'), group], []];
      const edited = new Set<string>();
      const enabled = new Set<string>();
      const faults: string[] = [];
      for (const action of actions.list.filter(({ id }) => !left.test(id))) {
        // the panels follow
        await new Promise(requestAnimationFrame);
        let runs = 0;
        for (const ids of selections) {
          if (runs === most) break;
          selection.set(ids);
          if (!(action.enabled?.(editor) ?? true)) continue;
          runs++;
          enabled.add(action.id);
          const before = editor.serialize();
          const steps = commands.history.length;
          await action.run(editor);
          dialogs.close(false);
          // a tool that waits for the user puts back what it shows
          tools.end();
          const after = editor.serialize();
          const made = commands.history.length - steps;
          if (made !== (after === before ? 0 : 1)) faults.push(`${action.id} made ${made} steps`);
          if (after === before) continue;
          edited.add(action.id);
          commands.undo();
          if (editor.serialize() !== before) faults.push(`${action.id} is not undone`);
          commands.redo();
          if (editor.serialize() !== after) faults.push(`${action.id} is not done again`);
          commands.undo();
        }
      }
      const all = actions.list.map(({ id }) => id).filter((id) => !left.test(id));
      Reflect.deleteProperty(viewport, 'renderNow');
      return { edited: [...edited], never: all.filter((id) => !enabled.has(id)), faults };
    },
    [beyond.source, most] as const,
  );
  const { edited, never, faults } = found;
  expect(faults).toEqual([]);
  const known = ['cut', 'paste', 'paste-below', 'duplicate', 'group', 'ungroup', 'delete', 'hide', 'lock'];
  expect(edited).toEqual(expect.arrayContaining([...known.map((id) => `edit.${id}`), 'prefab.make', 'prefab.unpack']));
  // what wants an imported model is in assetEdits.test.ts, the view that a digit recalls in views.spec.ts, and keys that are
  // recorded in timeline.spec.ts
  const views = Array.from({ length: 9 }, (_, i) => `view.bookmark.${i + 1}`);
  expect(never).toEqual(['timeline.record', 'model.unpack', ...views]);
});
