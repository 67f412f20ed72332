import { addObject, history, openEditor, serialized } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 900, height: 480 } });

test('searches, groups, cuts, pastes and locks, and takes all of it back', async ({ page }) => {
  await addObject(page, 'Mesh', 'Box');
  await addObject(page, 'Mesh', 'Cone');
  const before = await serialized(page);
  const steps = await history(page);

  // by part of a name and of a component; Enter goes to the first
  const search = page.getByRole('searchbox', { name: 'Search objects' });
  await search.fill('objectrenderer');
  await expect(page.getByRole('treeitem')).toHaveCount(2);
  await search.fill('con renderer');
  await expect(page.getByRole('treeitem')).toHaveCount(1);
  await page.keyboard.press('Enter');
  await expect(page.getByRole('treeitem', { name: 'Cone' })).toBeFocused();
  // all that is listed, not all that there is
  await search.fill('renderer');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Control+a');
  await expect(page.getByRole('treeitem', { selected: true })).toHaveCount(2);
  await search.fill('');
  await expect(page.getByRole('treeitem', { selected: true })).toHaveCount(2);
  // a name is emptied and typed anew
  await page.getByRole('treeitem', { name: 'Box' }).click();
  await page.keyboard.press('F2');
  const renamed = page.getByRole('treeitem').getByRole('textbox');
  for (const key of ['Control+a', 'Delete', 'C', 'Escape']) {
    await page.keyboard.press(key);
    if (key === 'C') await expect(renamed).toHaveValue('C');
  }
  await expect(page.getByRole('treeitem')).toHaveCount(5);

  await page.getByRole('treeitem', { name: 'Box' }).click();
  await page.getByRole('treeitem', { name: 'Cone' }).click({ modifiers: ['Shift'] });
  await page.keyboard.press('Control+g');
  await expect(page.getByRole('treeitem', { name: 'Group' })).toHaveAttribute('aria-selected', 'true');
  // the rows that had the focus are gone: it is on the group, not lost
  await expect(page.getByRole('treeitem', { name: 'Group' })).toBeFocused();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('treeitem', { name: 'Cone' })).toHaveAttribute('aria-level', '2');

  await page.getByRole('treeitem', { name: 'Cone' }).click();
  await page.keyboard.press('Control+x');
  await expect(page.getByRole('treeitem', { name: 'Cone' })).toHaveCount(0);
  await page.getByRole('treeitem', { name: 'Sun' }).click();
  await page.keyboard.press('Control+v');
  await page.keyboard.press('Control+v');
  await expect(page.getByRole('treeitem', { name: 'Cone' })).toHaveCount(2);
  await page.keyboard.press('l');
  await expect(page.getByRole('button', { name: 'Unlock Cone 2' })).toBeVisible();
  expect(await history(page)).toEqual([
    ...steps,
    'Grouped 2 objects',
    'Deleted Cone',
    'Pasted Cone',
    'Pasted Cone',
    'Locked Cone 2',
  ]);
  for (let i = 0; i < 5; i++) await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(before);

  // a double click looks at the object, unless it is on a switch of its row
  await page.evaluate(() => {
    const { viewport } = window.editor;
    const { dataset } = document.documentElement;
    viewport.focus = () => {
      dataset.focused = String(Number(dataset.focused ?? 0) + 1);
    };
  });
  for (const name of ['Hide Box', 'Lock Box']) await page.getByRole('button', { name }).dblclick();
  await page.getByRole('treeitem', { name: 'Box' }).dblclick({ position: { x: 60, y: 8 } });
  const focused = await page.evaluate(() => {
    Reflect.deleteProperty(window.editor.viewport, 'focus');
    const { focused } = document.documentElement.dataset;
    delete document.documentElement.dataset.focused;
    return focused;
  });
  expect(focused).toBe('1');
  expect((await history(page)).slice(steps.length)).toEqual(['Hid Box', 'Showed Box', 'Locked Box', 'Unlocked Box']);
});

test('what was copied is there in another tab of the browser @verify', async ({ page }) => {
  await addObject(page, 'Mesh', 'Cone');
  await page.keyboard.press('Control+c');
  const other = await page.context().newPage();
  await other.setViewportSize(page.viewportSize()!);
  await openEditor(other, 'empty');
  await other.getByRole('treeitem', { name: 'Sun' }).click();
  await other.keyboard.press('Control+v');
  await expect(other.getByRole('treeitem', { name: 'Cone' })).toHaveCount(1);
});

test('selects with the keyboard from the row that was chosen to another, however fast the keys come', async ({
  page,
}) => {
  for (const mesh of ['Box', 'Cone', 'Torus', 'Sphere', 'Cylinder']) await addObject(page, 'Mesh', mesh);
  const selected = page.getByRole('treeitem', { selected: true });
  await page.getByRole('treeitem', { name: 'Torus' }).click();

  await page.keyboard.press('Home');
  await expect(selected).toHaveText(['Camera']);
  // keys that come within one frame, as of a key that is held
  await page.getByRole('treeitem', { name: 'Camera' }).evaluate((row) => {
    for (let i = 0; i < 5; i++) {
      const key = { key: 'ArrowDown', code: 'ArrowDown', shiftKey: true, bubbles: true };
      row.dispatchEvent(new KeyboardEvent('keydown', { key: 'Shift', code: 'ShiftLeft', bubbles: true }));
      row.dispatchEvent(new KeyboardEvent('keydown', key));
      row.dispatchEvent(new KeyboardEvent('keyup', key));
    }
  });
  await expect(selected).toHaveText(['Camera', 'Sun', 'Sky', 'Box', 'Cone', 'Torus']);
  await page.keyboard.press('Shift+ArrowUp');
  await expect(selected).toHaveText(['Camera', 'Sun', 'Sky', 'Box', 'Cone']);
  await page.keyboard.press('Shift+End');
  await expect(selected).toHaveCount(8);
  await page.keyboard.press('End');
  await expect(selected).toHaveText(['Cylinder']);
  await page.keyboard.press('Shift+Home');
  await expect(selected).toHaveCount(8);

  // a click with Shift goes on from where the keys began
  await page.keyboard.press('ArrowDown');
  await page.getByRole('treeitem', { name: 'Box' }).click({ modifiers: ['Shift'] });
  await expect(selected).toHaveText(['Sun', 'Sky', 'Box']);
});

test('the focus goes from rows that are grouped to the group, also where the page is busy in between', async ({
  page,
}) => {
  for (const mesh of ['Box', 'Cone']) await addObject(page, 'Mesh', mesh);
  await page.getByRole('treeitem', { name: 'Box' }).click();
  await page.getByRole('treeitem', { name: 'Cone' }).click({ modifiers: ['Shift'] });
  // a frame and its timers come after the rows have gone, and before what React does next, which it does by messages
  await page.evaluate(() => {
    const { requestAnimationFrame: frame, cancelAnimationFrame: cancel, setTimeout: later } = window;
    const post = MessagePort.prototype.postMessage;
    const putBack = (): void => {
      MessagePort.prototype.postMessage = post;
      Object.assign(window, { requestAnimationFrame: frame, cancelAnimationFrame: cancel, setTimeout: later });
    };
    Object.assign(window, { putBack });
    const isLost = (): boolean => document.activeElement === document.body;
    const asked = new Map<number, FrameRequestCallback>();
    let lastId = 0;
    window.requestAnimationFrame = (callback) => (asked.set(--lastId, callback), lastId);
    window.cancelAnimationFrame = (id) => void (asked.delete(id) || cancel(id));
    window.setTimeout = ((handler: () => void, ms?: number) => later(handler, isLost() ? 0 : ms)) as typeof setTimeout;
    const goOn = (time: number): void => {
      window.requestAnimationFrame = frame;
      for (const callback of asked.values()) callback(time);
    };
    MessagePort.prototype.postMessage = function (
      this: MessagePort,
      ...message: Parameters<MessagePort['postMessage']>
    ) {
      const send = (): void => post.apply(this, message);
      if (!isLost()) return send();
      frame((time) => {
        goOn(time);
        later(() => later(send));
      });
    } as typeof post;
  });
  await page.keyboard.press('Control+g');
  await expect(page.getByRole('treeitem', { name: 'Group' })).toBeFocused();
  await page.evaluate(() => (Reflect.get(window, 'putBack') as () => void)());
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('treeitem', { name: 'Cone' })).toHaveAttribute('aria-level', '2');
});

test('what is added below many rows comes into sight', async ({ page }) => {
  await addObject(page, 'Mesh', 'Box');
  await page.keyboard.press('Shift+d');
  await page.getByRole('textbox', { name: 'Count' }).fill('30');
  await page.getByRole('button', { name: 'Duplicate', exact: true }).last().click();
  await page.getByRole('treeitem', { name: 'Copies of Box' }).focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('treeitem', { name: 'Box 2', exact: true })).toBeVisible();
  await addObject(page, 'Mesh', 'Cone');
  await expect(page.getByRole('treeitem', { name: 'Cone' })).toBeInViewport({ ratio: 0.9 });
});
