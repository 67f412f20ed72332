import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 460, height: 340 }, reducedMotion: 'no-preference' });

// unit tests play them too, and playedPages.spec.ts one of them
test('samples that are files open, play 20 steps, and are as they were once they are stopped @verify', async ({
  page,
}) => {
  const names = await page.evaluate(() =>
    Object.keys(window.editor.samples).filter((name) => window.editor.samples[name].file !== null),
  );
  expect(names).toHaveLength(11);
  for (const name of names) {
    const seen = await page.evaluate(async (name) => {
      const { editor } = window;
      await editor.openSample(name);
      // takes the software rasteriser seconds a frame
      editor.document.scene.settings.set('volumetricFog', false);
      editor.viewport.renderNow();
      const { document } = editor;
      const { simulation, scene } = document;
      await document.scripts.settled();
      const before = editor.serialize();
      const places = (): string => {
        const list: number[] = [];
        scene.traverse(({ object3D: { position, quaternion } }) => list.push(...position, ...quaternion));
        for (const light of scene.componentsOf('Light')) list.push(light.get('intensity') as number);
        return list.join();
      };
      const still = places();
      for (let i = 0; i < 20; i++) simulation.step();
      const moved = places() !== still;
      simulation.stop();
      const { visible } = editor.viewport.farol.info.lights;
      return { moved, lights: visible, same: editor.serialize() === before, back: places() === still };
    }, name);
    expect(seen, name).toMatchObject({ same: true, back: true });
    // prefabs rest, and bodies wait for Rapier: how they move, the unit tests of the samples say
    if (name !== 'prefabs' && name !== 'physics') expect(seen.moved, name).toBe(true);
    expect(seen.lights, name).toBeGreaterThan(1);
    expect(await page.getByRole('alert').count(), name).toBe(0);
  }
});
