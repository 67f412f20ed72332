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
          ...{ technique, one, unlit, additive },
          sortedApart: compareImages(orders[0].sorted, orders[1].sorted).largest,
          weightedApart: compareImages(orders[0].weighted, orders[1].weighted).largest,
          near: compareImages(orders[0].sorted, orders[0].weighted).psnr,
        };
      });
    },
    [120, 80, TECHNIQUES] as const,
  );
  for (const { technique, one, unlit, additive, sortedApart, weightedApart, near } of results) {
    // sums in half floats
    expect(one, technique).toBeLessThan(2e-3);
    expect(unlit, technique).toBeLessThan(2e-3);
    expect(additive, technique).toBeLessThan(1e-3);
    expect(sortedApart, `${technique}: order matters when sorted`).toBeGreaterThan(0.02);
    expect(weightedApart, technique).toBeLessThan(2e-3);
    expect(near, `${technique}: near what sorting gives`).toBeGreaterThan(18);
  }
});
