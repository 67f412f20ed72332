import { expect, test } from '../support/test';

test.beforeEach(async ({ page, pagesURL }) => {
  await page.goto(pagesURL);
  await page.waitForFunction(() => 'testPage' in window);
});

test('the host finds its scene, renderer, device and three as they were, and stock three draws the same after Farol', async ({
  page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, farol, hostSnapshot, materialScene, three } = window.testPage;
    const bench = new Bench(80, 60);
    const { scene, camera } = materialScene(80, 60, { count: 8, onlyDeferred: true });
    // what Farol switches for a moment: nested lights, order, transmission, clearing
    const glass = new three.Mesh(new three.SphereGeometry(0.5), new three.MeshPhysicalMaterial({ transmission: 1 }));
    const hider = new three.Mesh(new three.PlaneGeometry(), new three.MeshStandardMaterial({ colorWrite: false }));
    hider.renderOrder = -1;
    const nested = new three.SpotLight(0xffffff, 5);
    nested.layers.enable(3);
    scene.add(glass, hider, new three.Group().add(nested));
    const { webgl } = bench;
    webgl.setClearColor(0x123456, 0.5);
    const first = bench.stock(scene, camera);
    return (Object.keys(farol.techniques) as (keyof typeof farol.techniques)[]).map((technique) => {
      bench.byTechnique(technique, scene, camera);
      bench.stock(scene, camera);
      const before = hostSnapshot(webgl, scene, camera);
      bench.byTechnique(technique, scene, camera);
      const after = hostSnapshot(webgl, scene, camera);
      const names = Object.keys({ ...before, ...after }).filter((name) => before[name] !== after[name]);
      const changed = names.map((name) => {
        let at = 0;
        while (before[name]?.[at] === after[name]?.[at]) at++;
        const part = (text = '') => text.slice(Math.max(0, at - 60), at + 60);
        return `${name}: ${part(before[name])} → ${part(after[name])}`;
      });
      return { technique, changed, again: compareImages(first, bench.stock(scene, camera)).largest };
    });
  });
  for (const { technique, changed, again } of results) {
    expect.soft(changed, `${technique}: the host is as it was`).toEqual([]);
    expect(again, `${technique}: stock three afterwards`).toBe(0);
  }
});
