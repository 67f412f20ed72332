import { checkAgreement } from '../support/agreement';
import { expect, test } from '../support/benchTest';

test('a polished floor mirrors area lights as in stock three, by every technique', async ({ benchPage: page }) => {
  const { pairs, isLit } = await page.evaluate(() => {
    const { addons, Bench, compareImages, techniquesInTurn, three } = window.testPage;
    addons.RectAreaLightUniformsLib.init();
    const [width, height] = [96, 54];
    const bench = new Bench(width, height);
    bench.farol.inferredScale = 1;
    bench.farol.areaLightThreshold = 0;
    const scene = new three.Scene();
    for (const [i, color] of [0xff0000, 0x00ff00, 0x0000ff].entries()) {
      const light = new three.RectAreaLight(color, 5, 4, 10);
      light.position.set(5 * i - 5, 5, 5);
      light.rotation.y = Math.PI;
      light.lookAt(5 * i - 5, 5, 0);
      scene.add(light);
    }
    const floor = new three.Mesh(
      new three.BoxGeometry(2000, 0.1, 2000),
      new three.MeshStandardMaterial({ color: 0xbcbcbc, roughness: 0.1 }),
    );
    const knot = new three.Mesh(
      new three.TorusKnotGeometry(1.5, 0.5, 48, 12),
      new three.MeshStandardMaterial({ roughness: 0, metalness: 0 }),
    );
    knot.position.y = 5;
    scene.add(floor, knot);
    const camera = new three.PerspectiveCamera(45, width / height, 1, 1000);
    camera.position.set(0, 5, -15);
    camera.lookAt(knot.position);
    const stock = bench.stock(scene, camera);
    return {
      isLit: stock.data.reduce((most, value) => Math.max(most, value), 0),
      pairs: techniquesInTurn(2).map((technique) => ({
        technique,
        ...compareImages(stock, bench.byTechnique(technique, scene, camera)),
      })),
    };
  });
  expect(isLit).toBeGreaterThan(1);
  for (const { technique, ...difference } of pairs) checkAgreement(technique, difference, 'polished floor');
});

test('a polished floor goes into a G-buffer again once the area lights are gone', async ({ benchPage: page }) => {
  const draws = await page.evaluate(() => {
    const { Bench, three } = window.testPage;
    const bench = new Bench(32, 32);
    const floor = new three.Mesh(new three.PlaneGeometry(), new three.MeshStandardMaterial({ roughness: 0.1 }));
    const area = new three.RectAreaLight(0xffffff, 5);
    area.position.z = 1;
    const point = new three.PointLight();
    point.position.z = 1;
    const scene = new three.Scene().add(floor, area, point);
    const camera = new three.PerspectiveCamera();
    camera.position.z = 2;
    return (['deferred', 'light-prepass', 'inferred'] as const).map((technique) => {
      return [true, false].map((visible) => {
        area.visible = visible;
        bench.byTechnique(technique, scene, camera);
        return bench.farol.info.passes.find(({ name }) => name.endsWith('g-buffer'))!.drawCalls;
      });
    });
  });
  expect(draws).toEqual([
    [0, 1],
    [0, 1],
    [0, 1],
  ]);
});
