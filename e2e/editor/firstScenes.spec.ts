import type { Locator, Page } from '@playwright/test';
import { expect, test } from './sharedEditor';
import { fieldOf, history, inspectorFollows } from './editor';

// the whole window of a small notebook: panels and picture are used as a newcomer does
test.use({ viewport: { width: 1280, height: 800 } });

/** Fog that twelve lamps light is drawn by a GPU alone: a frame of it takes the software rasteriser many seconds. */
const isGPU = process.env.FAROL_GPU === '1';

/** Does what a user does, and counts it: a click, a drag, a key, or a text typed at once is one action. */
class Hand {
  actions = 0;

  constructor(private readonly page: Page) {}

  async click(target: Locator): Promise<void> {
    this.actions++;
    await target.click();
  }

  async type(text: string): Promise<void> {
    this.actions++;
    await this.page.keyboard.type(text);
  }

  async press(key: string): Promise<void> {
    this.actions++;
    await this.page.keyboard.press(key);
  }

  /** @param at - point of the target, from 0 to 1 along its width and height */
  async drag(from: Locator, to: Locator, at: readonly [number, number]): Promise<void> {
    this.actions++;
    const { width, height } = (await to.boundingBox())!;
    await from.dragTo(to, { targetPosition: { x: width * at[0], y: height * at[1] } });
  }

  /** Adds from the library by the Add menu: three clicks. */
  async add(group: string, name: string): Promise<void> {
    const { page } = this;
    const steps = (await history(page)).length;
    await this.click(page.getByRole('button', { name: 'Add', exact: true }));
    await this.click(page.getByRole('menuitem', { name: group, exact: true }));
    await this.click(page.getByRole('menuitem', { name, exact: true }));
    await expect.poll(async () => (await history(page)).length).toBe(steps + 1);
    await inspectorFollows(page);
  }
}

const lamps = (page: Page) =>
  page.evaluate(() =>
    window.editor.document.scene
      .componentsOf('Light')
      .filter((light) => light.getAuthored('type') === 'spot')
      .map((light) => ({
        x: light.gameObject.transform.worldPosition.x,
        shadow: light.getAuthored('castShadow'),
        softness: light.getAuthored('shadowRadius'),
      })),
  );

test(
  'a street of twelve lamps with soft shadows, fog that they light (on a GPU) and a moon, from an empty scene, in at most 20 actions',
  { tag: '@verify' },
  async ({ page }) => {
    const hand = new Hand(page);
    const picture = page.locator('.viewport-place canvas').first();
    await hand.add('Props', 'Street');
    await hand.add('Sky', isGPU ? 'Foggy night' : 'Moonlit night');
    await hand.click(page.getByRole('tab', { name: 'Library' }));
    const library = page.getByRole('region', { name: 'Library' });
    await hand.drag(library.getByRole('button', { name: 'Street lamp' }), picture, [0.5, 0.44]);
    await expect.poll(async () => (await history(page)).at(-1)).toBe('Added Street lamp');
    const [, y] = (await fieldOf(page, 'Street lamp', 'Transform', 'position')) as number[];
    expect(y, 'on the pavement, or on the road').toBeGreaterThan(0);
    await hand.press('Shift+D');
    const box = page.getByRole('form', { name: 'Duplicate Street lamp' });
    await hand.click(box.getByRole('textbox', { name: 'Count' }));
    await hand.type('12');
    await hand.click(box.getByRole('textbox', { name: 'Distance x' }));
    await hand.type('3.2');
    await hand.press('Enter');
    await hand.click(box.getByRole('button', { name: 'Duplicate' }));
    await expect(box).toHaveCount(0);

    const made = await lamps(page);
    expect(made.length).toBe(12);
    expect(made.every(({ shadow, softness }) => shadow === true && (softness as number) > 1)).toBe(true);
    const places = made.map(({ x }) => x).toSorted((a, b) => a - b);
    expect(places.at(-1)! - places[0]).toBeCloseTo(11 * 3.2, 1);
    expect(await fieldOf(page, 'Sun', 'Light', 'castShadow')).toBe(true);
    const settings = ['sky', 'volumetricFog'];
    expect(
      await page.evaluate((names) => names.map((name) => window.editor.document.scene.settings.get(name)), settings),
    ).toEqual(['night', isGPU]);
    expect(hand.actions).toBeLessThanOrEqual(20);
  },
);

test(
  'a door that opens when the player comes near, in at most 15 actions, and it does when played',
  { tag: '@verify' },
  async ({ page }) => {
    const hand = new Hand(page);
    await hand.add('Behaviour', 'Door');
    await hand.add('Behaviour', 'Player');
    // away from the door: the player looks along -Z
    const door = (await fieldOf(page, 'Door', 'Transform', 'position')) as number[];
    await hand.click(page.getByRole('textbox', { name: 'Position x' }));
    await hand.type(String(door[0]));
    await hand.click(page.getByRole('textbox', { name: 'Position z' }));
    await hand.type(String(door[2] + 6));
    await hand.press('Enter');
    const turned = (): Promise<number> =>
      page.evaluate(() => {
        const { scene } = window.editor.document;
        return scene.find('Door')!.children.find(({ name }) => name === 'Hinge')!.object3D.rotation.y;
      });
    expect(await turned()).toBe(0);
    await page.evaluate(() => window.editor.document.scripts.settled());
    await hand.click(page.getByRole('button', { name: 'Play', exact: true }));
    await hand.click(page.locator('.viewport-place canvas').first());
    hand.actions++;
    await page.keyboard.down('w');
    await expect.poll(turned, { timeout: 60_000 }).toBeGreaterThan(0.5);
    await page.keyboard.up('w');
    expect(hand.actions).toBeLessThanOrEqual(15);
    await page.evaluate(() => window.editor.document.simulation.stop());
    expect(await turned()).toBe(0);
  },
);
