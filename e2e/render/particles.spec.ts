import { expect, test } from '../support/benchTest';

test('particles: the same twice, where the formula says, summed up, soft, lit, and lights as PointLights are', async ({
  benchPage: page,
  watch,
}) => {
  // where they are, whatever the frames
  const motion = await page.evaluate(async () => {
    const { Bench, effects, oneParticle, three, readTexels } = window.testPage;
    const bench = new Bench(16, 16, { losesContext: true });
    const particles = new effects.Particles();
    bench.farol.effects = [particles];
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera();
    const states = (emitter: InstanceType<typeof effects.ParticleEmitter>) => {
      const { positions, velocities } = particles.texturesOf(emitter)!;
      return [...readTexels(bench.webgl, positions), ...readTexels(bench.webgl, velocities)];
    };
    const draw = (emitter: InstanceType<typeof effects.ParticleEmitter>, steps: readonly number[], frames: boolean) => {
      scene.add(emitter);
      for (const seconds of steps) {
        emitter.step(seconds);
        if (frames) bench.byTechnique('forward-single-pass', scene, camera);
      }
      bench.byTechnique('forward-single-pass', scene, camera);
      const result = states(emitter);
      scene.remove(emitter);
      return result;
    };
    // everything that moves particles, at once
    const settings = {
      capacity: 60,
      seed: 5,
      rate: 40,
      life: [0.3, 0.9],
      speed: [1, 3],
      gravity: [0, -4, 0],
      drag: 0.4,
      noiseStrength: 3,
      colliders: [
        { kind: 'plane', normal: [0, 1, 0], height: -0.2, bounce: 0.6, friction: 0.1 },
        { kind: 'sphere', center: [0.2, 0, 0.8], radius: 0.3, bounce: 0.4, friction: 0 },
      ],
      prewarm: 0.2,
      shape: { kind: 'mesh', mesh: new three.Mesh(new three.TorusGeometry(1, 0.3, 6, 9)) },
    } as const;
    const steps = Array<number>(20).fill(0.05);
    const emitter = new effects.ParticleEmitter(settings);
    const first = draw(emitter, steps, true);
    emitter.restart();
    const second = draw(emitter, steps, false);
    const other = draw(new effects.ParticleEmitter({ ...settings, seed: 6 }), steps, false);
    const lost = await (async () => {
      await bench.loseContext();
      return draw(emitter, [], false);
    })();
    const begun = draw(new effects.ParticleEmitter(settings), [], false);

    // in the emitter's space: a particle at rest goes where the emitter goes, with the velocity that it has there
    const carried = oneParticle({
      ...{
        speed: [1, 1],
        space: 'local',
        shape: { kind: 'cone', radius: 0, angle: 0 },
        render: 'mesh',
        orientation: 'velocity',
      },
      particleGeometry: new three.BoxGeometry(),
    });
    draw(carried, [0.5], false);
    carried.position.set(2, 0, 1);
    carried.rotation.z = Math.PI / 2;
    // up to here it has gone 0.5 m along the emitter's +Y; what follows is too short to go anywhere
    const local = draw(carried, [1e-6], false);

    // one projectile, thrown 30 degrees from the upright, in long and short steps; with drag too
    const throws = [0, 0.8].map((drag) => {
      const thrown = oneParticle({
        bursts: [{ time: 0.1, count: 1 }],
        speed: [5, 5],
        shape: { kind: 'cone', radius: 0, angle: 0 },
        gravity: [0, -9.81, 0],
        drag,
      });
      thrown.position.set(1, 2, 3);
      thrown.rotation.z = -Math.PI / 6;
      return draw(thrown, [0.5, 0.013, 0.337, 0.25], true).slice(0, 4);
    });
    // to and fro between a wall and a ball
    const bounced = oneParticle({
      speed: [5, 5],
      shape: { kind: 'cone', radius: 0, angle: 0 },
      colliders: [
        { kind: 'plane', normal: [-2, 0, 0], height: -2, bounce: 1, friction: 0 },
        { kind: 'sphere', center: [-2, 0, 0], radius: 1, bounce: 0.5, friction: 0 },
      ],
    });
    bounced.rotation.z = -Math.PI / 2;
    const between = draw(bounced, [0.7, 0.013, 0.687], true).slice(0, 3);
    // 1 m over a floor, down at 45 degrees
    const slid = oneParticle({
      speed: [Math.SQRT2, Math.SQRT2],
      shape: { kind: 'cone', radius: 0, angle: 0 },
      colliders: [{ kind: 'plane', normal: [0, 1, 0], height: 0, bounce: 0.5, friction: 0.25 }],
    });
    slid.position.y = 1;
    slid.rotation.z = (-3 * Math.PI) / 4;
    const slowed = draw(slid, [0.4, 1.2, 0.4], true).slice(0, 3);
    return { first, second, other, lost, begun, throws, between, slowed, local };
  });
  expect(watch.forgive(/a WebGL context was lost|CONTEXT_LOST_WEBGL|THREE.WebGLRenderer: Context/)).toBeGreaterThan(0);
  expect(motion.first.filter((value) => value !== 0).length).toBeGreaterThan(200);
  expect(motion.second).toEqual(motion.first);
  expect(motion.other).not.toEqual(motion.first);
  expect(motion.lost).toEqual(motion.begun);
  const wanted = [1.5, 0, 1, 0.5, -1, 0, 0, 9];
  wanted.forEach((value, i) => expect(motion.local[i], 'space of the emitter').toBeCloseTo(value, 4));
  const [free, braked] = motion.throws;
  const [sine, cosine] = [0.5, Math.sqrt(0.75)];
  expect(free[0]).toBeCloseTo(1 + 5 * sine, 4);
  expect(free[1]).toBeCloseTo(2 + 5 * cosine - 9.81 / 2, 4);
  const share = (1 - Math.exp(-0.8)) / 0.8;
  expect(braked[0]).toBeCloseTo(1 + 5 * sine * share, 4);
  expect(braked[1]).toBeCloseTo(2 + 5 * cosine * share - (9.81 * (1 - share)) / 0.8, 4);
  // 2 m to the wall, 3 m back to the ball, and half as fast for the rest of 7 m
  expect(motion.between).toEqual([expect.closeTo(0, 4), expect.closeTo(0, 4), expect.closeTo(0, 4)]);
  // 1 m to the floor, then half as fast upwards and three quarters as fast along it for 1 s
  expect(motion.slowed).toEqual([expect.closeTo(1.75, 4), expect.closeTo(0.5, 4), expect.closeTo(0, 4)]);
  expect([free[2], free[3]]).toEqual([3, expect.closeTo(1, 5)]);

  // what they look like, and what they light
  const pictures = await page.evaluate(() => {
    const { Bench, compareImages, effects, three, readTexels } = window.testPage;
    const [width, height] = [64, 48];
    const bench = new Bench(width, height);
    const particles = new effects.Particles();
    const oit = new effects.WeightedBlendedOIT();
    bench.farol.effects = [particles];
    const camera = new three.PerspectiveCamera(45, width / height, 0.1, 20);
    camera.position.set(0, 1, 4);
    camera.lookAt(0, 0.5, 0);
    const scene = new three.Scene();
    scene.background = new three.Color(0, 0, 0);
    const still = { capacity: 40, rate: 0, bursts: [{ time: 0, count: 40 }], life: [9, 9], speed: [0, 0] } as const;
    const make = (settings: Partial<InstanceType<typeof effects.ParticleEmitter>>) => {
      const emitter = new effects.ParticleEmitter({ ...still, ...settings });
      emitter.position.y = 0.5;
      emitter.step(0.03);
      scene.add(emitter);
      return emitter;
    };
    /** The mean of the four pixels round the centre. */
    const middle = ({ data }: { data: Float32Array }) =>
      [0, 1, 2].map((channel) => {
        const at = 4 * ((height / 2) * width + width / 2) + channel;
        return (data[at] + data[at - 4] + data[at - 4 * width] + data[at - 4 * width - 4]) / 4;
      });
    const difference = (a: { data: Float32Array }, b: { data: Float32Array }) =>
      a.data.reduce((most, value, i) => Math.max(most, i % 4 === 3 ? 0 : Math.abs(value - b.data[i])), 0);

    const light = ({ data }: { data: Float32Array }) =>
      data.reduce((sum, value, i) => sum + (i % 4 === 3 ? 0 : value), 0);

    const plain = new three.DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);
    plain.needsUpdate = true;

    // additive: two pictures and their sum
    const box = { kind: 'box', size: [2, 1, 2] } as const;
    const white = [[0, [1, 0.5, 0.25], 0.5]] as const;
    const look = { shape: box, colorOverLife: white, softness: 0, size: [0.2, 0.6] } as const;
    const one = make({ ...look, seed: 2 });
    const two = make({ ...look, seed: 3, render: 'stretched', texture: plain });
    const both = bench.byTechnique('deferred', scene, camera);
    two.visible = false;
    const sum = bench.byTechnique('deferred', scene, camera);
    [one.visible, two.visible] = [false, true];
    const second = bench.byTechnique('deferred', scene, camera);
    sum.data.forEach((value, i) => (sum.data[i] = value + second.data[i]));
    const additive = { brightest: Math.max(...both.data), off: difference(both, sum) };
    scene.clear();

    // lights: particles too small to be seen, and PointLights where they are
    const floor = new three.Mesh(new three.PlaneGeometry(6, 6), new three.MeshStandardMaterial({ roughness: 0.6 }));
    floor.rotation.x = -Math.PI / 2;
    scene.add(floor);
    const shining = make({
      shape: box,
      colorOverLife: white,
      size: [0, 0],
      lightEvery: 3,
      lightIntensity: 4,
      lightRange: 1.5,
    });
    bench.byTechnique('deferred', scene, camera);
    const places = readTexels(bench.webgl, particles.texturesOf(shining)!.positions);
    const lit = (['deferred', 'clustered-forward', 'tiled-deferred', 'forward', 'forward-single-pass'] as const).map(
      (technique) => ({ technique, image: bench.byTechnique(technique, scene, camera) }),
    );
    scene.remove(shining);
    for (let i = 0; i < 40; i += 3) {
      const light = new three.PointLight(0xffffff, 1, 1.5);
      light.color.setRGB(2, 1, 0.5);
      light.position.fromArray(places, 4 * i);
      scene.add(light);
    }
    const wanted = bench.stock(scene, camera);
    const lights = lit.map(({ technique, image }) => ({ technique, ...compareImages(wanted, image, 6) }));
    scene.clear();

    // soft where they meet the floor, however depth is come by: the technique's, drawn once more, a copy
    floor.material = new three.MeshStandardMaterial({ color: 0 });
    floor.position.y = 0.45;
    scene.add(floor, new three.PointLight(0xffffff, 1, 1));
    const ball = {
      capacity: 1,
      bursts: [{ time: 0, count: 1 }],
      shape: { kind: 'point' },
      size: [1, 1],
      initialRotation: [0, 0],
    } as const;
    const opaque = [[0, [1, 1, 1], 1]] as const;
    const fog = make({ ...ball, colorOverLife: opaque, blending: 'weighted', softness: 0 });
    const hard = bench.byTechnique('forward-single-pass', scene, camera);
    fog.softness = 0.4;
    const soft = bench.byTechnique('forward-single-pass', scene, camera);
    const softDeferred = bench.byTechnique('deferred', scene, camera);
    bench.farol.effects = [particles, oit];
    const softCopied = bench.byTechnique('clustered-forward', scene, camera);
    const softness = {
      hard: light(hard),
      soft: light(soft),
      deferred: difference(soft, softDeferred),
      weighted: difference(soft, softCopied),
    };
    bench.farol.effects = [particles];
    scene.clear();

    // lit from the viewer's side, from one side, from behind, by a technique with lists and one without
    const white1 = make({
      ...ball,
      colorOverLife: opaque,
      blending: 'blended',
      softness: 0,
      lit: true,
      texture: plain,
    });
    const lamp = new three.DirectionalLight(0xffffff, 3);
    scene.add(white1, lamp);
    const toCamera = new three.Vector3().subVectors(camera.position, white1.position).normalize();
    const shades = [toCamera, new three.Vector3(1, 0, 0), toCamera.clone().negate()].map((direction) => {
      lamp.position.copy(direction);
      return (['clustered-deferred', 'deferred'] as const).map(
        (technique) => middle(bench.byTechnique(technique, scene, camera))[0],
      );
    });

    // sorted: the one in front hides the one behind it, whichever is older
    scene.clear();
    const sorted = [1, -1].map((way) => {
      const pair = make({
        ...ball,
        capacity: 70,
        rate: 2,
        bursts: [],
        life: [2, 2],
        speed: [1, 1],
        shape: { kind: 'cone', radius: 0, angle: 0 },
        colorOverLife: [[0, [0, 1, 0], 1], [0.3, [0, 1, 0], 1], [0.3, [1, 0, 0], 1]], // prettier-ignore
        blending: 'blended',
        softness: 0,
      });
      pair.rotation.x = (way * Math.PI) / 2;
      pair.restart();
      pair.step(1.15);
      const color = middle(bench.byTechnique('deferred', scene, camera));
      scene.remove(pair);
      return color;
    });
    // three draws nothing of them
    const left = make({ ...ball, softness: 0 });
    const stock = Math.max(...bench.stock(scene, camera).data.filter((_, i) => i % 4 !== 3));
    left.dispose();
    return { additive, lights, softness, shades, sorted, stock };
  });
  expect(pictures.additive.brightest).toBeGreaterThan(0.5);
  expect(pictures.additive.off).toBeLessThan(1e-5);
  for (const { technique, psnr } of pictures.lights) expect(psnr, technique).toBeGreaterThan(60);
  expect(pictures.softness.soft).toBeGreaterThan(0.2 * pictures.softness.hard);
  expect(pictures.softness.soft).toBeLessThan(0.9 * pictures.softness.hard);
  expect(pictures.softness.deferred).toBeLessThan(2e-3);
  expect(pictures.softness.weighted).toBeLessThan(4e-3);
  const [front, side, back] = pictures.shades;
  for (const value of front) expect(value).toBeCloseTo(3 / Math.PI, 2);
  for (const value of side) expect(value).toBeCloseTo(1.5 / Math.PI, 2);
  for (const value of back) expect(value).toBeLessThan(0.02);
  // older ones are red: towards the camera they are in front
  const [towards, away] = pictures.sorted;
  expect(towards[0]).toBeGreaterThan(0.8);
  expect(away[1]).toBeGreaterThan(0.8);
  expect(pictures.stock).toBe(0);
});
