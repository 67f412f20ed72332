import { expect, test } from '../support/benchTest';

/**
 * In a sphere with a light at its centre, whose wall shines as well, all points receive alike: after n bounces
 * (d + pi e) (1 + a + … + a^n), d the direct light, e the radiance, a the albedo.
 */
test('lights and what shines are reflected as often as asked, on grids of all scales; unlit and transparent meshes cast shadows @verify', async ({
  benchPage: page,
}) => {
  const found = await page.evaluate(async () => {
    const { Bench, three, bake } = window.testPage;
    const { bakeLightmaps } = await bake();
    const { webgl } = new Bench(8, 8);
    const half = three.DataUtils.fromHalfFloat;
    type Options = Parameters<typeof bakeLightmaps>[2];
    const shared = { size: 32, samples: 64, denoise: false, stitch: false, showProgress: false };
    const bakeOf = async (scene: InstanceType<typeof three.Scene>, options: Options) => {
      const warnings: string[] = [];
      const onWarning = (sentence: string) => void warnings.push(sentence);
      const baked = await bakeLightmaps(webgl, scene, { ...shared, onWarning, ...options });
      const { data } = baked.lightmaps[0];
      const texels = [...Array(data.length / 4).keys()].map((i) => [0, 1, 2].map((k) => half(data[4 * i + k])));
      baked.dispose();
      return { texels, warnings };
    };
    const meanOf = (texels: number[][]) => {
      const lit = texels.filter(([red]) => red > 0);
      return [0, 1, 2].map((k) => lit.reduce((sum, texel) => sum + texel[k], 0) / lit.length);
    };

    const wall = new three.MeshStandardMaterial({ side: three.BackSide, emissive: 0x000000, emissiveIntensity: 0.2 });
    const sphere = new three.Mesh(new three.SphereGeometry(1, 24, 16), wall);
    const lamp = new three.PointLight(0xffffff, 1);
    const room = new three.Scene().add(sphere, lamp);
    const direct = meanOf((await bakeOf(room, { bounces: 0 })).texels);
    wall.emissive.set(0xffffff);
    const rooms: { bounces: number; scale: number; albedo: number[]; mean: number[] }[] = [];
    for (const [bounces, scale, ...albedo] of [
      [0, 0.5, 0.6, 0.6, 0.6],
      [1, 1, 0.6, 0.6, 0.6],
      [1, 0.5, 0.6, 0.6, 0.6],
      [2, 0.25, 0.4, 0.4, 0.4],
      // the hue of what is reflected last is a mean's
      [3, 0.5, 0.7, 0.5, 0.2],
    ] as const) {
      wall.color.setRGB(albedo[0], albedo[1], albedo[2]);
      const { texels } = await bakeOf(room, { bounces, indirectScale: scale });
      rooms.push({ bounces, scale, albedo, mean: meanOf(texels) });
    }

    // a pane right over a floor, under a light without a size
    const floor = new three.Mesh(new three.PlaneGeometry(2, 2), new three.MeshLambertMaterial());
    const sun = new three.DirectionalLight(0xffffff, 2);
    sun.position.set(0, 0, 1);
    const panes: Record<string, { least: number; most: number }> = {};
    const { MeshBasicMaterial, MeshStandardMaterial, DoubleSide } = three;
    for (const [name, material] of Object.entries({
      unlit: new MeshBasicMaterial(),
      'unlit and clear': new MeshBasicMaterial({ transparent: true, opacity: 0.25 }),
      clear: new MeshStandardMaterial({ transparent: true, opacity: 0.75, side: DoubleSide }),
    })) {
      const pane = new three.Mesh(new three.PlaneGeometry(9, 9), material);
      pane.position.z = 1;
      const { texels } = await bakeOf(new three.Scene().add(floor, pane, sun), {
        bounces: 0,
        // only the floor's light is looked at: the pane takes the other lightmaps
        texelsPerMetre: 12,
        isStatic: () => true,
      });
      const inside = texels
        .filter((_, i) => i % 32 > 3 && i % 32 < 20 && i / 32 > 4 && i / 32 < 20)
        .map(([red]) => red);
      panes[name] = { least: Math.min(...inside), most: Math.max(...inside) };
    }
    return { direct, rooms, panes };
  });
  for (const { bounces, scale, albedo, mean } of found.rooms) {
    albedo.forEach((share, k) => {
      let series = 0;
      for (let i = 0; i <= bounces; i++) series += share ** i;
      const expected = series * (found.direct[k] + Math.PI * 0.2);
      expect(Math.abs(mean[k] / expected - 1), `${bounces} bounces of ${share}, scale ${scale}`).toBeLessThan(0.01);
    });
  }
  expect(found.panes.unlit).toEqual({ least: 0, most: 0 });
  for (const [name, share] of [
    ['unlit and clear', 0.75],
    ['clear', 0.25],
  ] as const) {
    expect(Math.abs(found.panes[name].least / (2 * share) - 1), name).toBeLessThan(1e-3);
    expect(Math.abs(found.panes[name].most / (2 * share) - 1), name).toBeLessThan(1e-3);
  }
});
