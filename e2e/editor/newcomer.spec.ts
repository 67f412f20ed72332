import type { GameObject, ObjectRenderer } from '@farol/engine';
import type { Locator, Page } from '@playwright/test';
import type { MeshPhysicalMaterial } from 'three';
import { expect, test } from '../support/test';
import { fieldOf, inspectorFollows, serialized, waitUntilReady } from './editor';
import { pixelAt, redBox, type TestFile } from './models';
import { test as shared } from './sharedEditor';

// a small picture: the software rasteriser draws every pixel on the CPU
test.use({ viewport: { width: 1000, height: 560 }, reducedMotion: 'reduce' });

/** A light, as far as these tests ask. */
interface Bulb {
  readonly type: string;
  readonly diffuse: readonly number[];
  readonly gameObject: GameObject;
}

/** Most actions (clicks, keys, drags) that a task may take. */
const MOST_ACTIONS = 40;

/**
 * A newcomer's mouse and keyboard. Each click, drag, key, typed text and chosen file is one action, and no task may
 * take more than MOST_ACTIONS of them.
 */
class Newcomer {
  actions = 0;
  readonly inspector: Locator;

  constructor(readonly page: Page) {
    this.inspector = page.getByRole('region', { name: 'Inspector' });
  }

  private act(): void {
    this.actions++;
    expect(this.actions, 'actions of the task').toBeLessThanOrEqual(MOST_ACTIONS);
  }

  async click(target: Locator): Promise<void> {
    this.act();
    await target.click();
  }

  async drag(from: Locator, to: Locator): Promise<void> {
    this.act();
    await from.dragTo(to);
  }

  async press(key: string): Promise<void> {
    this.act();
    await this.page.keyboard.press(key);
  }

  async type(text: string): Promise<void> {
    this.act();
    await this.page.keyboard.type(text);
  }

  async chooseFile(input: Locator, { name, bytes }: TestFile): Promise<void> {
    this.act();
    await input.setInputFiles({ name, buffer: bytes, mimeType: '' });
  }

  /** Opens the editor for the first time. */
  async begin(): Promise<Locator> {
    await this.page.goto('./');
    await waitUntilReady(this.page);
    const welcome = this.page.getByRole('dialog', { name: 'Welcome to Farol' });
    await expect(welcome).toBeVisible();
    return welcome;
  }

  async beginWithEmptyScene(): Promise<void> {
    const welcome = await this.begin();
    await this.click(welcome.getByRole('button', { name: 'Empty scene' }));
    await expect(this.page.getByRole('treeitem', { name: 'Sun' })).toBeVisible();
    await expect(welcome).toHaveCount(0);
  }

  /** Clicks through the menus: the name of one of the bar, or of the button Add, and those of its lines. */
  async choose(menu: string, ...lines: string[]): Promise<void> {
    const { page } = this;
    const isAdd = menu === 'Add';
    await this.click(page.getByRole(isAdd ? 'button' : 'menuitem', { name: menu, exact: true }));
    // a line's name ends with its key
    for (const line of lines) await this.click(page.getByRole('menuitem', { name: new RegExp(`^${line}( \\S+)?$`) }));
    await expect(page.getByRole('menu')).toHaveCount(0);
  }

  async add(kind: string, name: string): Promise<void> {
    await this.choose('Add', kind, name);
    await expect(
      this.page.getByRole('treeitem', { name: new RegExp(`^${name}( \\d+)?$`), selected: true }),
    ).toBeVisible();
    await inspectorFollows(this.page);
  }

  /** Clicks a field and types; a click selects what is there. */
  async fill(field: Locator, text: string): Promise<void> {
    await this.click(field);
    await this.type(text);
  }

  /** Types a number for each axis. @param first - the field of the first of them */
  async fillEach(first: Locator, ...numbers: number[]): Promise<void> {
    await this.click(first);
    for (const [i, number] of numbers.entries()) {
      if (i > 0) await this.press('Tab');
      await this.type(String(number));
    }
  }

  /** Clicks a colour, and in the picker that opens. @param across - how saturated @param down - how dark, both 0 to 1 */
  async chooseColour(field: Locator, across: number, down: number): Promise<void> {
    await this.click(field);
    const area = this.page.locator('.react-colorful__saturation');
    const { width, height } = (await area.boundingBox())!;
    this.act();
    await area.click({ position: { x: across * width, y: down * height } });
  }

  async pick(box: Locator, option: string): Promise<void> {
    await this.click(box);
    // a line of help may follow
    await this.click(this.page.getByRole('option', { name: new RegExp(`^${option}(?![\\w@,-])`) }));
  }
}

test('a newcomer makes a ring of 200 coloured lights over a floor @verify', async ({ page }, info) => {
  const newcomer = new Newcomer(page);
  await newcomer.beginWithEmptyScene();
  await newcomer.add('Mesh', 'Plane');
  for (const name of ['Sun', 'Sky']) {
    await newcomer.click(page.getByRole('treeitem', { name }));
    await newcomer.choose('Object', 'Hide');
  }
  await newcomer.add('Light', 'Point light');
  await newcomer.fill(newcomer.inspector.getByLabel('Position y'), '0.8');
  await newcomer.choose('Object', 'Duplicate along…');
  const box = page.getByRole('form', { name: 'Duplicate Point light' });
  await newcomer.pick(box.getByRole('combobox', { name: 'Where' }), 'On a ring');
  await newcomer.pick(box.getByRole('combobox', { name: 'Colours' }), 'All hues in turn');
  await newcomer.fill(box.getByLabel('Radius'), '4');
  await newcomer.fill(box.getByLabel('Count'), '200');
  await newcomer.click(box.getByLabel('Share the brightness of one light'));
  await expect(box).toContainText('200 in all');
  await newcomer.click(box.getByRole('button', { name: 'Duplicate' }));
  await expect(box).toHaveCount(0);

  const lights = await page.evaluate(() => {
    const { scene } = window.editor.document;
    const [x, , z] = scene.find('Plane')!.transform.position;
    return (scene.componentsOf('Light') as unknown as Bulb[])
      .filter(({ type }) => type === 'point')
      .map(({ diffuse, gameObject: { transform } }) => {
        const place = transform.worldPosition;
        return { colour: diffuse.join(), height: place.y, distance: Math.hypot(place.x - x, place.z - z) };
      });
  });
  expect(lights).toHaveLength(200);
  expect(new Set(lights.map(({ colour }) => colour)).size).toBe(200);
  for (const { height, distance } of lights) {
    expect(height).toBeCloseTo(0.8, 3);
    expect(distance).toBeCloseTo(4, 3);
  }
  const [left, right] = [await pixelAt(page, 0.14, 0.55), await pixelAt(page, 0.78, 0.56)];
  expect(left[2], 'the floor is blue on the left').toBeGreaterThan(1.5 * left[0]);
  expect(right[0], 'and red on the right').toBeGreaterThan(1.5 * right[2]);
  await page.screenshot({ path: info.outputPath('ring.png') });
});

test('a newcomer lights an imported model and shares it @verify', async ({ page, context, browser }, info) => {
  const newcomer = new Newcomer(page);
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const welcome = await newcomer.begin();
  await newcomer.chooseFile(welcome.getByLabel('Choose files of a model'), redBox());
  await expect(page.getByRole('treeitem', { name: 'box' })).toBeVisible();
  await newcomer.add('Light', 'Point light');
  const { inspector } = newcomer;
  await newcomer.fill(inspector.getByLabel('Position x'), '1.5');
  await newcomer.press('Enter');
  await newcomer.choose('File', 'Export and share…');
  const dialog = page.getByRole('dialog', { name: 'Export Untitled' });
  await newcomer.click(dialog.getByRole('region', { name: 'Link' }).getByRole('button', { name: 'Copy' }));
  await expect(page.getByText('Link copied').first()).toBeVisible();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  const scene = await serialized(page);

  // somebody else's browser
  const other = await browser.newPage();
  const problems: string[] = [];
  other.on('pageerror', (error) => problems.push(error.message));
  other.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
  await other.goto(link);
  await waitUntilReady(other);
  await expect(other.getByRole('treeitem', { name: 'box' })).toBeVisible();
  expect(await serialized(other)).toBe(scene);
  expect(problems).toEqual([]);
  await other.screenshot({ path: info.outputPath('opened.png') });
  await other.close();
});

test('a newcomer makes a material with three maps that two objects share @verify', async ({ page }, info) => {
  const newcomer = new Newcomer(page);
  await newcomer.beginWithEmptyScene();
  await newcomer.add('Mesh', 'Box');
  await newcomer.add('Mesh', 'Sphere');
  await newcomer.choose('Object', 'New material');
  const { inspector } = newcomer;
  await newcomer.pick(inspector.getByRole('combobox', { name: 'Colour map' }), 'Brick');
  await newcomer.pick(inspector.getByRole('combobox', { name: 'Normal map' }), 'Brick, normal map');
  await newcomer.pick(inspector.getByRole('combobox', { name: 'Roughness map' }), 'Checker');
  const card = page.locator('[data-asset="Material"]');
  for (const name of ['Box', 'Sphere']) {
    await newcomer.drag(card, page.getByRole('treeitem', { name }));
    await expect.poll(() => fieldOf(page, name, 'ObjectRenderer', 'material')).toBe('Material');
  }
  const [box, sphere] = await page.evaluate(() =>
    ['Box', 'Sphere'].map((name) => {
      const renderer = window.editor.document.scene.find(name)!.getComponent('ObjectRenderer') as ObjectRenderer;
      const { uuid, map, normalMap, roughnessMap } = renderer.three!.material as MeshPhysicalMaterial;
      return { uuid, maps: [map, normalMap, roughnessMap].filter((each) => each !== null).length };
    }),
  );
  expect(box).toEqual({ uuid: sphere.uuid, maps: 3 });
  expect(sphere.maps).toBe(3);
  await inspectorFollows(page);
  // nothing has moved the window's contents
  expect(await page.locator('.dock').evaluate((dock) => dock.scrollTop)).toBe(0);
  await page.screenshot({ path: info.outputPath('maps.png') });
});

test('a newcomer makes a lit room with a door and a lamp @verify', async ({ page }, info) => {
  const newcomer = new Newcomer(page);
  const { inspector } = newcomer;
  await newcomer.beginWithEmptyScene();
  await newcomer.add('Mesh', 'Box');
  await newcomer.fill(inspector.getByLabel('Position y'), '1.5');
  await newcomer.fillEach(inspector.getByLabel('Scale x'), 6, 3, 6);
  await newcomer.click(inspector.getByRole('button', { name: 'Make material asset' }));
  await newcomer.click(inspector.getByRole('button', { name: 'Opacity', exact: true }));
  await newcomer.pick(inspector.getByRole('combobox', { name: 'Side' }), 'Back');
  await newcomer.add('Mesh', 'Box');
  await newcomer.fillEach(inspector.getByLabel('Position y'), 1, -4.15);
  await newcomer.fillEach(inspector.getByLabel('Scale y'), 2, 0.1);
  await newcomer.chooseColour(inspector.getByLabel('Colour', { exact: true }), 0.7, 0.5);
  await newcomer.add('Mesh', 'Sphere');
  const wall = async (): Promise<number> => (await pixelAt(page, 0.33, 0.4))[1];
  const unlit = await wall();
  await newcomer.fill(inspector.getByLabel('Position y'), '2.4');
  await newcomer.pick(inspector.getByRole('combobox', { name: 'Add component' }), 'Light(?! Group)');
  await newcomer.fill(inspector.getByLabel('Intensity', { exact: true }), '12');
  await newcomer.chooseColour(inspector.getByLabel('Emissive', { exact: true }), 0.2, 0.1);
  await expect.poll(wall, 'the wall is lit by the lamp').toBeGreaterThan(1.5 * unlit);
  await page.screenshot({ path: info.outputPath('lamp.png') });
});

shared('a newcomer adds a room, moves its door and measures it by its fields', async ({ page }) => {
  const newcomer = new Newcomer(page);
  await newcomer.choose('Add', 'Room');
  await expect(page.getByRole('treeitem', { name: 'Room', selected: true })).toBeVisible();
  const room = newcomer.inspector.getByRole('region', { name: 'Room', exact: true });
  await newcomer.fill(room.getByLabel('Width', { exact: true }), '6');
  await newcomer.press('Enter');
  await newcomer.pick(room.getByRole('combobox', { name: 'Wall with the door' }), 'Left');
  expect(await fieldOf(page, 'Room', 'Room', 'door')).toBe('left');
  const width = await page.evaluate(() => {
    const renderer = window.editor.document.scene.find('Room')!.getComponent('ObjectRenderer') as ObjectRenderer;
    const { geometry } = renderer.three!;
    geometry.computeBoundingBox();
    return geometry.boundingBox!.max.x - geometry.boundingBox!.min.x;
  });
  // and two walls
  expect(width).toBeCloseTo(6.3, 5);
});
