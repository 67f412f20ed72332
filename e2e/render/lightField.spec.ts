import type { TechniqueName } from '@farol/renderer';
import { checkAgreement } from '../support/agreement';
import type { Difference } from '../support/images';
import { expect, test } from '../support/benchTest';

test('lights of fields look as the same lights one by one, by every technique', async ({ benchPage: page }) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, lightFields, randomIn, techniquesInTurn, three } = window.testPage;
    const width = 64;
    const height = 48;
    const bench = new Bench(width, height);
    bench.farol.inferredScale = 1;
    const random = randomIn(1);
    const scene = new three.Scene();
    const floor = new three.Mesh(new three.PlaneGeometry(24, 24), new three.MeshStandardMaterial({ roughness: 0.6 }));
    floor.rotation.x = -Math.PI / 2;
    scene.add(floor);
    for (let i = 0; i < 8; i++) {
      const ball = new three.Mesh(new three.SphereGeometry(0.8, 12, 8), floor.material);
      ball.position.set(random(-5, 5), 0.8, random(-8, 3));
      scene.add(ball);
    }
    const glass = new three.Mesh(
      new three.PlaneGeometry(2, 2),
      new three.MeshStandardMaterial({ transparent: true, opacity: 0.5 }),
    );
    glass.position.set(0, 1.5, 3);
    scene.add(glass, new three.DirectionalLight(0x334455, 0.5));
    const lone = new three.PointLight(0x5577ff, 5, 6);
    lone.position.set(2, 2, 2);
    const beam = new three.SpotLight(0xffffff, 20, 9, 0.5, 0.3);
    beam.position.set(-3, 4, 2);
    const near = new three.PointLight(0x88ff88, 1, 5);
    near.position.set(-2, 1, 3);
    near.userData.farol = { attenuation: { kind: 'near-far', near: 1, far: 4 } };
    scene.add(lone, beam, beam.target, near);
    const camera = new three.PerspectiveCamera(50, width / height, 0.1, 60);
    camera.position.set(0, 3, 8);
    camera.lookAt(0, 0.5, -2);

    // under a parent that is turned and scaled: ranges stay metres
    const parent = new three.Group();
    parent.rotation.y = 0.4;
    parent.scale.setScalar(1.5);
    parent.position.x = 0.5;
    scene.add(parent);
    const makeField = (count: number, spots: boolean) => {
      const field = new lightFields.LightField(count, { spots });
      const lights: InstanceType<typeof three.Light>[] = [];
      for (let i = 0; i < count; i++) {
        const [x, y, z] = [random(-6, 6), random(0.2, 2), random(-8, 5)];
        const range = random(0.5, 2.5);
        const colour = new three.Color(random(0, 0.5), random(0, 0.5), random(0, 0.5));
        const decay = i % 5 === 0 ? 1 : 2;
        field.setPoint(i, x, y, z, range, colour.r, colour.g, colour.b, decay);
        if (spots && i % 2) {
          const [dx, dz] = [random(-1, 1), random(-1, 1)];
          field.setCone(i, dx, -1, dz, 0.3 + i / 200, 0.2 + (i % 4) / 5);
          const light = new three.SpotLight(0xffffff, 1, range, 0.3 + i / 200, 0.2 + (i % 4) / 5, decay);
          light.target.position.set(x + dx, y - 1, z + dz);
          lights.push(light);
        } else lights.push(new three.PointLight(0xffffff, 1, range, decay));
        const light = lights[i];
        light.color.copy(colour);
        light.position.set(x, y, z);
      }
      return { field, lights };
    };
    const points = makeField(300, false);
    const mixed = makeField(150, true);
    // what lights nothing: no range, no number, behind `count`
    const bad = new lightFields.LightField(5);
    bad.setPoint(0, 0, 1, 0, 0, 9, 9, 9);
    bad.setPoint(1, 0, 1, 0, -1, 9, 9, 9);
    bad.setPoint(2, NaN, 1, 0, 3, 9, 9, 9);
    bad.setPoint(3, 0, 1, 0, 3, 9, Infinity, 9);
    bad.setPoint(4, 0, 1, 0, 3, 9, 9, 9);
    bad.count = 4;
    const show = (fields: readonly (typeof points)[], asFields: boolean) => {
      parent.clear();
      for (const { field, lights } of fields) {
        if (asFields) parent.add(field);
        else
          for (const light of lights) {
            parent.add(light);
            if ('target' in light) parent.add(light.target as typeof parent);
          }
      }
      if (asFields) parent.add(bad);
    };
    const found: (Difference & { name: string; technique: TechniqueName })[] = [];
    const seen: Record<string, number> = {};
    const counts: Record<string, number> = {};
    const all = techniquesInTurn(3);
    const some = techniquesInTurn(1, ['forward', 'deferred', 'tiled-deferred', 'clustered-forward']);
    for (const [name, fields] of Object.entries({ points: [points], 'points and spots': [mixed, points] })) {
      for (const technique of name === 'points' ? all : some) {
        show(fields, false);
        const alone = bench.byTechnique(technique === 'forward' ? 'forward-single-pass' : technique, scene, camera);
        show(fields, true);
        const picture = bench.byTechnique(technique, scene, camera);
        found.push({ name, technique, ...compareImages(alone, picture) });
        if (name === 'points') {
          const { programs } = bench;
          points.field.count = 40;
          bench.byTechnique(technique, scene, camera);
          points.field.count = 300;
          seen[technique] = bench.programs - programs;
        }
      }
      bench.byTechnique('deferred', scene, camera);
      counts[name] = bench.farol.info.lights.total;
    }
    // moved by its matrix and by a range of its array
    for (const { field, lights } of [points]) {
      field.position.y = 0.3;
      field.setPosition(7, 0, 1, 2);
      field.setRange(8, 0);
      for (const light of lights) light.position.y += 0.3;
      lights[7].position.set(0, 1.3, 2);
      lights[8].intensity = 0;
    }
    show([points], false);
    const alone = bench.byTechnique('tiled-deferred', scene, camera);
    show([points], true);
    found.push({
      name: 'moved',
      technique: 'tiled-deferred',
      ...compareImages(alone, bench.byTechnique('tiled-deferred', scene, camera)),
    });
    return { found, seen, counts };
  });
  for (const { technique, name, ...difference } of results.found) checkAgreement(technique, difference, name);
  expect(
    Object.values(results.seen).every((programs) => programs === 0),
    JSON.stringify(results.seen),
  ).toBe(true);
  // with the four lights beside them, and those of the third field
  expect(results.counts).toEqual({ points: 308, 'points and spots': 458 });
});

test('of 32 lights, which share a box, one far from the others is in the lists of its tiles and depths too', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, lightFields, three } = window.testPage;
    const bench = new Bench(256, 16);
    const scene = new three.Scene();
    // a wall that goes from the left far into the picture
    const wall = new three.Mesh(new three.PlaneGeometry(90, 8), new three.MeshStandardMaterial());
    wall.rotation.y = -Math.PI / 4;
    const camera = new three.PerspectiveCamera(8, 16, 1, 120);
    camera.position.z = 60;
    const field = new lightFields.LightField(32);
    const lights = Array.from({ length: 32 }, () => new three.PointLight(0xff88ff, 1, 2));
    scene.add(wall, field, ...lights);
    // 31 on one side, which order them before or after the one on the other
    const cases = [-1, 1].flatMap((side) =>
      (['tiled-deferred', 'clustered-forward'] as const).map((technique) => ({ side, technique })),
    );
    return cases.map(({ side, technique }) => {
      lights.forEach((light, i) => {
        const at = i < 31 ? side * (12 + 0.3 * i) : side * -22;
        light.position.set(at - 0.5, 0, at + 0.5);
        field.setPoint(i, at - 0.5, 0, at + 0.5, 2, light.color.r, light.color.g, light.color.b);
      });
      const [alone, together, lone] = ([32, 0, 31] as const).map((first) => {
        lights.forEach((light, i) => (light.visible = first === 31 ? i === 31 : first === 32));
        field.visible = first === 0;
        return bench.byTechnique(technique, scene, camera);
      });
      for (const light of lights) light.visible = false;
      const dark = bench.byTechnique(technique, scene, camera);
      const name = `${technique}, ${side}`;
      return { name, off: compareImages(alone, together).largest, lit: compareImages(dark, lone).largest };
    });
  });
  for (const { name, off, lit } of results) {
    expect(lit, name).toBeGreaterThan(0.1);
    expect(off, name).toBeLessThan(2e-3);
  }
});

test('a field lights what the camera sees if it shares a layer with the camera, as lights do in three', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { Bench, compareImages, effects, lightFields, three } = window.testPage;
    const bench = new Bench(32, 24);
    const scene = new three.Scene();
    const wall = new three.Mesh(new three.PlaneGeometry(6, 6), new three.MeshStandardMaterial());
    wall.layers.set(2);
    scene.add(wall);
    const camera = new three.PerspectiveCamera(60, 4 / 3, 0.1, 20);
    camera.position.z = 4;
    const field = new lightFields.LightField(1);
    field.setPoint(0, 0, 0, 1, 3, 2, 1, 3);
    const lone = new three.PointLight(new three.Color(2, 1, 3), 1, 3);
    lone.position.z = 1;
    const pairs = [
      ['both on other layers than each other, both seen', 1, [1, 2]],
      ['on the layer of the camera', 2, [2]],
      ['on a layer that it does not see', 1, [2]],
      ['on the layer that objects are on by default', 0, [2]],
    ] as const;
    const found = pairs.map(([name, layer, layers]) => {
      camera.layers.disableAll();
      for (const each of layers) camera.layers.enable(each);
      lone.layers.set(layer);
      field.layers.set(layer);
      scene.add(lone);
      const stock = bench.stock(scene, camera);
      scene.remove(lone);
      scene.add(field);
      const { largest } = compareImages(stock, bench.byTechnique('clustered-forward', scene, camera));
      scene.remove(field);
      return { name, largest, brightest: Math.max(...stock.data.filter((_, i) => i % 4 !== 3)) };
    });

    // lights of particles are on the layers of their emitter
    const emitter = new effects.ParticleEmitter({
      capacity: 1,
      rate: 0,
      bursts: [{ time: 0, count: 1 }],
      speed: [0, 0],
      size: [0, 0],
      shape: { kind: 'point' },
      lightEvery: 1,
      lightIntensity: 3,
      lightRange: 3,
    });
    emitter.position.z = 1;
    emitter.layers.set(2);
    emitter.step(0.1);
    scene.add(emitter);
    bench.farol.effects = [new effects.Particles()];
    const [of2, of1] = [2, 1].map((layer) => {
      camera.layers.set(2);
      emitter.layers.set(layer);
      const { data } = bench.byTechnique('clustered-forward', scene, camera);
      return Math.max(...data.filter((_, i) => i % 4 !== 3));
    });
    return { found, of2, of1 };
  });
  for (const { name, largest } of seen.found) expect(largest, name).toBeLessThan(1e-4);
  expect(seen.found.map(({ brightest }) => brightest > 0.05)).toEqual([true, true, false, false]);
  expect(seen.of2).toBeGreaterThan(0.05);
  expect(seen.of1).toBe(0);
});
