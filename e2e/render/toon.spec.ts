import { expect, test } from '../support/benchTest';

/** Toon shading takes derivatives of each light, which a loop that differs from pixel to pixel does not have. */
test('toon materials walk the lists of lights as others do, and look as in stock three', async ({
  benchPage: page,
}) => {
  const figures = await page.evaluate(() => {
    const { Bench, compareImages, three } = window.testPage;
    const bench = new Bench(160, 120);
    const scene = new three.Scene();
    const toon = new three.MeshToonMaterial();
    const lambert = new three.MeshLambertMaterial();
    const ball = new three.SphereGeometry(0.9, 24, 16);
    const meshes = Array.from({ length: 12 }, () => new three.Mesh<typeof ball, typeof toon | typeof lambert>(ball));
    for (let i = 0; i < 12; i++) meshes[i].position.set((i % 4) * 2 - 3, Math.floor(i / 4) * 2 - 2, 0);
    scene.add(...meshes, new three.DirectionalLight(0xffffff, 1));
    for (let i = 0; i < 24; i++) {
      const light = new three.PointLight(0xffffff, 3, 3);
      light.color.setHSL(i / 24, 0.7, 0.6);
      light.position.set(((i * 7) % 24) / 3 - 4, ((i * 5) % 24) / 4 - 3, 1.2);
      scene.add(light);
    }
    const camera = new three.PerspectiveCamera(50, 4 / 3, 0.1, 60);
    camera.position.z = 8;
    const by = (
      technique: 'tiled-forward' | 'forward-plus' | 'clustered-forward',
      material: typeof toon | typeof lambert,
    ) => {
      for (const mesh of meshes) mesh.material = material;
      return bench.byTechnique(technique, scene, camera);
    };
    for (const mesh of meshes) mesh.material = toon;
    const stock = bench.stock(scene, camera);
    return (['tiled-forward', 'forward-plus', 'clustered-forward'] as const).map((technique) => {
      bench.farol.view = 'final';
      const { largest } = compareImages(stock, by(technique, toon));
      bench.farol.view = 'light-count';
      return { technique, largest, counts: compareImages(by(technique, lambert), by(technique, toon)).largest };
    });
  });
  for (const { technique, largest, counts } of figures) {
    expect(largest, technique).toBeLessThan(2e-5); // measured: 2.9e-6
    expect(counts, `lights counted by ${technique}`).toBe(0);
  }
});
