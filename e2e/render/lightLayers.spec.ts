import { expect, test } from '../support/benchTest';

test('with lightLayers a light reaches only what shares a layer with it, by every technique; else all, as in three', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { Bench, techniquesInTurn, three } = window.testPage;
    const [width, height] = [128, 32];
    const bench = new Bench(width, height);
    bench.webgl.shadowMap.enabled = true;
    const scene = new three.Scene();
    const camera = new three.OrthographicCamera(-8, 8, 2, -2, 0.1, 20);
    camera.position.z = 8;
    camera.layers.enableAll();
    const material = new three.MeshStandardMaterial({ roughness: 0.6 });
    // walls side by side: layer 0 alone, layers 0 and 17, layer 17 alone, which most objects have
    const masks = [1, 1 | (1 << 17), 1 << 17, 1 << 17];
    masks.forEach((mask, i) => {
      const wall = new three.Mesh(new three.PlaneGeometry(3.6, 3.6), material);
      wall.position.x = (i - 1.5) * 4;
      wall.layers.mask = mask;
      wall.receiveShadow = true;
      scene.add(wall);
    });
    const lights = [
      Object.assign(new three.PointLight(0xff4020, 30, 12), { name: 'first' }),
      Object.assign(new three.DirectionalLight(0x2040ff, 0.6), { name: 'other' }),
      Object.assign(new three.SpotLight(0x20ff40, 60, 14, 1.2), { name: 'both' }),
      Object.assign(new three.PointLight(0x404040, 30, 0), { name: 'other, without a range' }),
    ];
    lights.forEach((light, i) => {
      light.position.set(i - 1, 0.5, 3);
      light.layers.mask = [1, 1 << 17, 1 | (1 << 17), 1 << 17][i];
      scene.add(light);
    });
    lights[2].castShadow = true;
    // what each wall is to show: stock three with the lights that share a layer with it
    const middle = (data: Float32Array, i: number) => {
      const at = 4 * ((height / 2) * width + 16 + i * 32);
      return Array.from(data.slice(at, at + 3));
    };
    const wanted = masks.map((mask, i) => {
      for (const light of lights) light.visible = (light.layers.mask & mask) !== 0;
      return middle(bench.stock(scene, camera).data, i);
    });
    for (const light of lights) light.visible = true;
    const all = masks.map((_, i) => middle(bench.stock(scene, camera).data, i));
    const names = techniquesInTurn(0);
    return {
      wanted,
      all,
      drawn: names.map((technique) => {
        const draw = (on: boolean) => {
          bench.farol.lightLayers = on;
          const { data } = bench.byTechnique(technique, scene, camera);
          return masks.map((_, i) => middle(data, i));
        };
        return { technique, on: draw(true), off: technique === 'deferred' ? draw(false) : null };
      }),
    };
  });
  const near = (a: number[][], b: number[][]) =>
    Math.max(...a.flatMap((colour, i) => colour.map((value, c) => Math.abs(value - b[i][c]))));
  expect(near(seen.wanted, seen.all), 'layers are to be seen').toBeGreaterThan(0.05);
  for (const { technique, off, on } of seen.drawn) {
    if (off) expect(near(off, seen.all), `${technique}, off`).toBeLessThan(0.004);
    expect(near(on, seen.wanted), `${technique}, on`).toBeLessThan(0.004);
  }
});
