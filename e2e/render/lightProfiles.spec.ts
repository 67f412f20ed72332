import { expect, test } from '../support/benchTest';

/** How far a pixel may be from the formula, as part of the brightest: profiles are kept in half floats. */
const LARGEST = 1e-3;
/** G-buffers keep normals in half floats, and add light in them. */
const LARGEST_DEFERRED = 3e-3;
/** Light at half the resolution, smoothed. */
const LARGEST_INFERRED = 0.08;
const FORWARD = new Set(['forward', 'forward-single-pass', 'tiled-forward', 'forward-plus', 'clustered-forward']);

test('lights with photometric profiles light a floor by every technique as the file says, worked out pixel by pixel', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { Bench, drawn, isSlice, lightProfiles, setLightOptions, techniquesInTurn, three } = window.testPage;
    const { IESLoader } = lightProfiles;
    const size = 32;
    const bench = new Bench(size, size);
    bench.webgl.shadowMap.enabled = true;
    // no plane is as another
    const planes = [0, 1, 2, 3].map((h) =>
      [0, 1, 2, 3, 4, 5, 6].map((v) => 100 - 9 * v + (h * 53 * v) / (v + 1)).join(' '),
    );
    const text = `IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 7 4 1 2 0 0 0 1 1 10\n0 15 30 45 60 75 180\n0 90 180 270\n${planes.join('\n')}`;
    const profile = new IESLoader().parse(text);
    const otherPlanes = [5, 9, 2].map((factor) => `${factor * 3} ${factor * 2} ${factor}`).join('\n');
    const other = new IESLoader().parse(
      `IESNA91\nTILT=NONE\n1 -1 1 3 3 2 2 0 0 0 1 1 10\n-90 0 90\n-90 0 90\n${otherPlanes}`,
    );
    const grey = new three.DataTexture(new Uint8Array(64).fill(128), 4, 4);
    grey.needsUpdate = true;
    const { Vector3 } = three;
    type Lamp = InstanceType<typeof three.PointLight> | InstanceType<typeof three.SpotLight>;
    /** Intensity of a lamp without its profile, by distance. */
    const factors = new Map<Lamp, (distance: number) => number>();
    const falloff = (range: number) => (d: number) =>
      (1 / (d * d)) * (range > 0 ? Math.max(0, 1 - (d / range) ** 4) ** 2 : 1);
    const point = (colour: number, range: number) => {
      const lamp = new three.PointLight(colour, 3, range);
      lamp.position.set(0.4, -0.3, 1.1);
      lamp.rotation.set(1.2, 0.4, -0.7);
      setLightOptions(lamp, { profile: profile.texture });
      factors.set(lamp, falloff(range));
      return lamp;
    };
    const spot = (colour: number, range: number) => {
      const lamp = new three.SpotLight(colour, 3, range, 1.5);
      lamp.position.set(-0.5, 0.2, 1.3);
      lamp.rotation.set(0.3, 0.2, 0.9);
      lamp.target.position.set(0.3, 0.1, 0);
      setLightOptions(lamp, { profile: profile.texture });
      factors.set(lamp, falloff(range));
      return lamp;
    };
    const thesis = point(0x0000ff, 0);
    thesis.userData.farol = { attenuation: { kind: 'near-far', near: 1, far: 5 } };
    factors.set(thesis, (d) => Math.min(1, Math.max(0, (5 - d) / 4)));
    const thrown = spot(0x00ff00, 9);
    thrown.map = grey;
    thrown.shadow.camera.near = 0.01;
    factors.set(thrown, (d) => (falloff(9)(d) * 128) / 255);
    const shadowed = spot(0x0000ff, 9);
    shadowed.castShadow = true;
    setLightOptions(shadowed, { profile: other.texture });
    const cube = point(0x00ff00, 6);
    cube.castShadow = true;
    const scenes = [
      [point(0xff0000, 0), cube, thesis],
      [spot(0xff0000, 0), thrown, shadowed],
    ];
    const camera = new three.OrthographicCamera(-2, 2, 2, -2, 0.1, 10);
    camera.position.z = 5;
    const floor = new three.Mesh(new three.PlaneGeometry(4, 4), new three.MeshLambertMaterial());
    floor.receiveShadow = true;
    const sceneOf = (lamps: Lamp[]) => {
      const scene = new three.Scene();
      scene.add(floor.clone());
      for (const lamp of lamps) {
        scene.add(lamp);
        if (lamp instanceof three.SpotLight) scene.add(lamp.target);
      }
      return scene;
    };
    /** By the definition of the frame in `LightOptions.profile`. */
    const radiance = (lamp: Lamp, x: number, y: number) => {
      lamp.updateMatrixWorld();
      const away = new Vector3(x, y, 0).sub(lamp.position);
      const d = away.length();
      away.divideScalar(d);
      const { matrixWorld } = lamp;
      const across = new Vector3().setFromMatrixColumn(matrixWorld, 0);
      let down = new Vector3().setFromMatrixColumn(matrixWorld, 1).negate();
      if (lamp instanceof three.SpotLight) {
        down = lamp.target.position.clone().sub(lamp.position).normalize();
        across.addScaledVector(down, -across.dot(down)).normalize();
      }
      const quarter = new Vector3().crossVectors(across, down);
      const degrees = 180 / Math.PI;
      const vertical = Math.acos(away.dot(down)) * degrees;
      const horizontal = Math.atan2(away.dot(quarter), away.dot(across)) * degrees;
      const file = lamp === shadowed ? other : profile;
      const part = file.intensityAt(vertical, horizontal) / file.maximumIntensity;
      return (3 * part * factors.get(lamp)!(d) * -away.z) / Math.PI;
    };
    const built = scenes.map((lamps) => ({ lamps, scene: sceneOf(lamps) }));
    const names = techniquesInTurn(4, drawn);
    const results = names.map((technique, turn) => {
      // in the slice one scene by each
      const seen = built.filter((_, index) => !isSlice || index === turn % built.length);
      const worst = seen.map(({ lamps, scene }) => {
        const { data } = bench.byTechnique(technique, scene, camera);
        return lamps.map((lamp, channel) => {
          let brightest = 0;
          let largest = 0;
          const c = lamp.color.r > 0 ? 0 : lamp.color.g > 0 ? 1 : 2;
          for (let j = 0; j < size; j++) {
            for (let i = 0; i < size; i++) {
              const wanted = radiance(lamp, ((i + 0.5) / size) * 4 - 2, ((j + 0.5) / size) * 4 - 2);
              brightest = Math.max(brightest, wanted);
              largest = Math.max(largest, Math.abs(data[4 * (j * size + i) + c] - wanted));
            }
          }
          return { lamp: `${lamp.type} ${channel}`, error: largest / brightest };
        });
      });
      return { technique, worst: worst.flat() };
    });
    // more lights, other profiles, none, and new data in a texture: no program changes
    const { scene, lamps } = built[0];
    bench.byTechnique('clustered-deferred', scene, camera);
    const { programs } = bench;
    const middle = () => {
      const { data } = bench.byTechnique('clustered-deferred', scene, camera);
      return Array.from(data.slice(4 * (16 * size + 16), 4 * (16 * size + 16) + 3));
    };
    const more = Array.from({ length: 40 }, (_, i) => {
      const lamp = i % 2 === 0 ? point(0x000001, 8) : spot(0x000001, 8);
      setLightOptions(lamp, { profile: i % 3 === 0 ? profile.texture : other.texture });
      return lamp;
    });
    scene.add(...more);
    bench.byTechnique('clustered-deferred', scene, camera);
    for (const lamp of more) scene.remove(lamp);
    const before = middle();
    const { image } = profile.texture;
    const data = image.data as unknown as Uint16Array;
    const kept = data.slice();
    for (let i = 0; i < data.length; i++)
      data[i] = three.DataUtils.toHalfFloat(three.DataUtils.fromHalfFloat(kept[i]) / 2);
    profile.texture.needsUpdate = true;
    const halved = middle();
    setLightOptions(lamps[0], { profile: null });
    const without = middle();
    setLightOptions(lamps[0], { profile: profile.texture });
    data.set(kept);
    profile.texture.needsUpdate = true;
    return { results, programs: bench.programs - programs, before, halved, without, again: middle() };
  });
  for (const { technique, worst } of seen.results) {
    const limit = FORWARD.has(technique) ? LARGEST : technique === 'inferred' ? LARGEST_INFERRED : LARGEST_DEFERRED;
    for (const { lamp, error } of worst) expect.soft(error, `${technique}, ${lamp}`).toBeLessThan(limit);
  }
  expect(seen.programs, 'programs made by more lights').toBe(0);
  for (const c of [0, 1, 2]) expect(seen.halved[c] / seen.before[c]).toBeCloseTo(0.5, 2);
  expect(seen.without[0]).toBeGreaterThan(seen.before[0] * 1.05);
  expect(seen.again).toEqual(seen.before);
});
