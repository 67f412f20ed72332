import { expect, test } from '../support/benchTest';

const TECHNIQUES = [
  'forward',
  'forward-single-pass',
  'deferred',
  'tiled-deferred',
  'forward-plus',
  'light-prepass',
] as const;

test('weighted blending: one layer is as sorted, several are the same in any order, other blending stays', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(
    ([width, height, techniques]) => {
      const { Bench, compareImages, effects, techniquesInTurn, three } = window.testPage;
      const bench = new Bench(width, height);
      const scene = new three.Scene();
      scene.background = new three.Color(0.2, 0.3, 0.4);
      const back = new three.Mesh(
        new three.BoxGeometry(2, 2, 0.2),
        new three.MeshStandardMaterial({ color: 0x888866, roughness: 0.8 }),
      );
      back.position.z = -1;
      const layer = (material: InstanceType<typeof three.Material>, z: number) => {
        material.transparent = true;
        const mesh = new three.Mesh(new three.PlaneGeometry(2.5, 1.5), material);
        mesh.position.z = z;
        scene.add(mesh);
        return mesh;
      };
      const red = layer(new three.MeshStandardMaterial({ color: 0xff4422, opacity: 0.5 }), 0);
      const blue = layer(new three.MeshBasicMaterial({ color: 0x2244ff, opacity: 0.4, side: three.DoubleSide }), 0.4);
      blue.rotation.z = 0.5;
      blue.rotation.y = 0.3;
      const glow = layer(new three.MeshBasicMaterial({ color: 0x113311, blending: three.AdditiveBlending }), 0.8);
      const lamp = new three.PointLight(0xffffff, 10, 8);
      lamp.position.set(0.5, 1, 2);
      scene.add(back, lamp, new three.AmbientLight(0xffffff, 0.5));
      const camera = new three.PerspectiveCamera(50, width / height, 0.1, 20);
      camera.position.z = 4;
      const oit = new effects.WeightedBlendedOIT();
      const draw = (technique: (typeof techniques)[number], on: boolean) => {
        bench.farol.effects = on ? [oit] : [];
        return bench.byTechnique(technique, scene, camera);
      };
      const pair = (technique: (typeof techniques)[number]) =>
        compareImages(draw(technique, false), draw(technique, true));
      return techniquesInTurn(1, techniques).map((technique) => {
        blue.visible = glow.visible = false;
        red.visible = true;
        const one = pair(technique).largest;
        red.visible = false;
        blue.visible = true;
        const unlit = pair(technique).largest;
        // its colour is multiplied by its opacity already
        Object.assign(blue.material, { premultipliedAlpha: true, needsUpdate: true });
        const premultiplied = pair(technique).largest;
        Object.assign(blue.material, { premultipliedAlpha: false, needsUpdate: true });
        blue.visible = false;
        glow.visible = true;
        const additive = pair(technique).largest;
        red.visible = blue.visible = true;
        const orders = [
          [0, 1],
          [1, 0],
        ].map(([first, second]) => {
          red.renderOrder = first;
          blue.renderOrder = second;
          return { sorted: draw(technique, false), weighted: draw(technique, true) };
        });
        red.renderOrder = blue.renderOrder = 0;
        return {
          ...{ technique, one, unlit, premultiplied, additive },
          sortedApart: compareImages(orders[0].sorted, orders[1].sorted).largest,
          weightedApart: compareImages(orders[0].weighted, orders[1].weighted).largest,
          near: compareImages(orders[0].sorted, orders[0].weighted).psnr,
        };
      });
    },
    [120, 80, TECHNIQUES] as const,
  );
  for (const { technique, one, unlit, premultiplied, additive, sortedApart, weightedApart, near } of results) {
    // sums in half floats
    expect(one, technique).toBeLessThan(2e-3);
    expect(unlit, technique).toBeLessThan(2e-3);
    expect(premultiplied, `${technique}: premultiplied`).toBeLessThan(2e-3);
    expect(additive, technique).toBeLessThan(1e-3);
    expect(sortedApart, `${technique}: order matters when sorted`).toBeGreaterThan(0.02);
    expect(weightedApart, technique).toBeLessThan(2e-3);
    expect(near, `${technique}: near what sorting gives`).toBeGreaterThan(18);
  }
});

test('weighted blending: of faint layers the nearer counts more, by the formula of its paper', async ({
  benchPage: page,
}) => {
  const OPACITY = 0.02;
  const seen = await page.evaluate((opacity) => {
    const { Bench, effects, three } = window.testPage;
    const bench = new Bench(8, 8);
    const camera = new three.PerspectiveCamera(50, 1, 0.1, 20);
    const scene = new three.Scene();
    scene.background = new three.Color(0, 0, 0);
    for (const [color, away] of [
      [0xff0000, 2],
      [0x00ff00, 6],
    ]) {
      const material = new three.MeshBasicMaterial({ color, opacity, transparent: true });
      const layer = new three.Mesh(new three.PlaneGeometry(20, 20), material);
      layer.position.z = -away;
      scene.add(layer);
    }
    bench.farol.effects = [new effects.WeightedBlendedOIT()];
    return [...bench.byTechnique('deferred', scene, camera).data.slice(0, 3)];
  }, OPACITY);
  // depth as the buffer has it, 0 at the near plane and 1 at the far one; McGuire and Bavoil 2013, equation 10
  const weightOf = (away: number) => (1 - 0.9 * ((20 / 19.9) * (1 - 0.1 / away))) ** 3;
  const share = weightOf(2) / (weightOf(2) + weightOf(6));
  const hidden = 1 - (1 - OPACITY) ** 2;
  // sums in half floats
  expect(seen[0] / hidden).toBeCloseTo(share, 2);
  expect(seen[1] / hidden).toBeCloseTo(1 - share, 2);
});
