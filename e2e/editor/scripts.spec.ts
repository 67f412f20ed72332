import { pathToFileURL } from 'node:url';
import { inflateRawSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import { deadTabOf } from '../support/deadTab';
import { test as own } from '../support/test';
import { addObject, openEditor, serialized } from './editor';
import { expect, test } from './sharedEditor';

own.use({ viewport: { width: 1000, height: 560 }, reducedMotion: 'reduce' });

const spin = (axis: string): string => `import { component, number } from '@farol/engine/fields';
import { Vector3 } from 'three';
export default class Spin extends component({ rate: number(1, { unit: 'rad/s', help: 'How fast it turns.' }) }) {
  private readonly axis = new Vector3(0, 1, 0);
  readonly markup = '</SCRIPT ><title>led away</title><!-- <script>';
  start(): void {
    document.body.dataset.runs = '${axis}';
  }
  override update(deltaSeconds: number): void {
    this.gameObject.object3D.rotate${axis}(this.rate * this.axis.length() * deltaSeconds);
    document.body.dataset.turned = 'yes';
  }
}`;

/** The text of the scene in a link. */
const sceneOfLink = (link: string): string =>
  inflateRawSync(Buffer.from(link.split('#scene=')[1], 'base64url')).toString();

/** Value that the script left on the page, and the rotation of its object. */
const turnOf = (page: Page): Promise<{ runs: unknown; y: number; z: number }> =>
  page.evaluate(() => {
    const { rotation } = window.editor.document.scene.find('Box')!.object3D;
    return { runs: document.body.dataset.runs, y: rotation.y, z: rotation.z };
  });

test('a script turns an object, an edit is live with its values, and the exported page plays it', async ({
  page,
  context,
}, info) => {
  await addObject(page, 'Mesh', 'Box');
  await page.evaluate(async (source) => {
    const { assets, scripts, scene } = window.editor.document;
    assets.addFieldAsset('script', 'Spin', { source });
    await scripts.settled();
    scene.find('Box')!.addComponent('Spin', { rate: 3 });
  }, spin('Y'));
  const before = await serialized(page);

  // it runs, and a change of its text is live while it plays
  await page.keyboard.press('Control+p');
  await expect.poll(async () => (await turnOf(page)).y).not.toBe(0);
  await page.evaluate((source) => window.editor.document.assets.fieldAsset('Spin')!.set('source', source), spin('Z'));
  // a unit test holds that this takes 300 ms at most
  await expect.poll(async () => (await turnOf(page)).runs).toBe('Z');
  await expect.poll(async () => (await turnOf(page)).z).not.toBe(0);
  expect(await page.evaluate(() => window.editor.document.scene.find('Box')!.getComponent('Spin')!.get('rate'))).toBe(
    3,
  );
  await page.keyboard.press('Control+p');
  expect(await turnOf(page)).toMatchObject({ y: 0, z: 0 });
  expect(await serialized(page)).toBe(before.replace('rotateY', 'rotateZ').replace("runs = 'Y'", "runs = 'Z'"));

  // the page plays from a disk, without a network
  await page.keyboard.press('Control+Shift+E');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Web page…' }).click();
  const html = info.outputPath('scene.html');
  await (await download).saveAs(html);
  const fromDisk = await context.newPage();
  const problems: string[] = [];
  fromDisk.on('pageerror', (error) => problems.push(error.message));
  fromDisk.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
  await fromDisk.setViewportSize({ width: 200, height: 120 });
  await fromDisk.goto(pathToFileURL(html).href);
  await expect(fromDisk).toHaveTitle('Untitled');
  await fromDisk.waitForFunction(() => document.body.dataset.turned === 'yes');
  expect(problems).toEqual([]);
  await fromDisk.close();

  // from elsewhere it opens with its scripts off, and says so
  const text = (await serialized(page)).replace("runs = 'Z'", "runs = 'X'");
  await page.evaluate((file) => void window.editor.openFileBytes(file, { name: 'Other.farol', handle: null }), text);
  await page.getByRole('button', { name: 'Don’t save' }).click();
  const bar = page.getByRole('alert', { name: 'Scripts are off' });
  await expect(bar).toContainText('it comes from elsewhere');
  const typeOf = (): Promise<boolean> => page.evaluate(() => window.editor.document.scripts.classOf('Spin') !== null);
  expect(await typeOf()).toBe(false);
  // nor do they run for others without a word
  await page.keyboard.press('Control+Shift+E');
  const link = page.getByLabel('Link to the scene');
  await expect(link).toHaveValue(/#scene=/);
  const without = await link.inputValue();
  expect(sceneOfLink(without)).not.toContain('class Spin');
  await page.getByRole('checkbox', { name: 'With the scripts, which are off here' }).check();
  await expect(link).not.toHaveValue(without);
  expect(sceneOfLink(await link.inputValue())).toContain('class Spin');
  await page.getByRole('button', { name: 'Close', exact: true }).click();
  await bar.getByRole('button', { name: 'Run them' }).click();
  await expect(bar).toBeHidden();
  await expect.poll(typeOf).toBe(true);
});

/** A pattern that takes longer than anyone waits: no loop of the script's, which would be ended. */
const stuck = `import { component } from '@farol/engine/fields';
export default class Stuck extends component({}) {
  update() { console.info('stuck'); /^(a+)+$/.test('a'.repeat(99) + 'b'); }
}`;

own(
  'a tab that hung in a script, and was ended, comes back with scripts off, until they are mended @verify',
  async ({ page }) => {
    await openEditor(page, 'empty');
    await page.evaluate(async (source) => {
      const { assets, scripts, scene } = window.editor.document;
      assets.addFieldAsset('script', 'Stuck', { source });
      await scripts.settled();
      scene.find('Sun')!.addComponent('Stuck');
    }, stuck);
    await addObject(page, 'Mesh', 'Box');
    await page.waitForFunction(() => window.editor.autosave?.isUpToDate);
    const tab = await deadTabOf(page);
    const hung = page.waitForEvent('console', (message) => message.text() === 'stuck');
    // never answered: the page does not come to it
    void page.keyboard.press('Control+p').catch(() => {});
    await hung;
    await tab.killAndReload();

    const button = (name: string): string =>
      `[...document.querySelectorAll('[role=dialog] button, [role=alert] button')].find((each) => each.textContent === '${name}')`;
    await expect
      .poll(() => tab.evaluate(`${button('Recover')} && (${button('Recover')}.click(), 'clicked')`))
      .toBe('clicked');
    const bar = `document.querySelector('[role=alert][aria-label="Scripts are off"]')?.textContent`;
    await expect.poll(() => tab.evaluate(bar)).toContain('the page ended while they ran');
    const known = `window.editor.document.scripts.classOf('Stuck') !== null`;
    expect(await tab.evaluate(known)).toBe(false);
    // it plays without them, and with the one that was mended
    await tab.evaluate(`window.editor.document.simulation.step()`);
    await tab.evaluate(`window.editor.document.simulation.stop()`);
    await tab.evaluate(`{
    const script = window.editor.document.assets.fieldAsset('Stuck');
    script.set('source', script.get('source').replace(/update.*/, "update() { document.title = 'mended'; }"));
  }`);
    await tab.evaluate(`${button('Run them')}.click()`);
    await expect.poll(() => tab.evaluate(known)).toBe(true);
    await tab.evaluate(`window.editor.document.simulation.step()`);
    await expect.poll(() => tab.evaluate('document.title')).toBe('mended');
    expect(await tab.evaluate(bar)).toBeUndefined();
  },
);
