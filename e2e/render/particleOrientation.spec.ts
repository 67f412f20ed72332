import type { Object3D, Quaternion, Vector3 } from 'three';
import { expect, test } from '../support/benchTest';

/** Pixels that may differ (share): those at edges, where a sum in another order falls on the other side. */
const EDGES = 0.005;

test('meshes of particles stand as the emitter, along their way, or as the world until they are turned, as meshes of three do', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { Bench, oneParticle, compareImages, effects, isFlat, readTexels, three } = window.testPage;
    type Settings = Partial<InstanceType<typeof effects.ParticleEmitter>>;
    const [width, height] = [96, 72];
    const bench = new Bench(width, height);
    const particles = new effects.Particles();
    bench.farol.effects = [particles];
    const camera = new three.PerspectiveCamera(45, width / height, 0.1, 20);
    camera.position.set(1.2, 0.8, 2.4);
    camera.lookAt(0.6, 0.3, 0);
    const scene = new three.Scene();
    scene.background = new three.Color(0);
    const sun = new three.DirectionalLight(0xffffff, 3);
    sun.position.set(0.3, 1, 0.8);
    scene.add(sun);
    // no two sides alike; and one that looks the same from all sides of its +Y
    const flag = new three.BoxGeometry(0.15, 1, 0.5).translate(0.05, 0.2, 0.2);
    const cone = new three.ConeGeometry(0.3, 1.2, 48);

    /** A single particle, thrown and pulled aside where `settings` do not let it rest. */
    const draw = (settings: Settings) => {
      const emitter = oneParticle({
        ...{ speed: [1.5, 1.5], seed: 3, shape: { kind: 'cone', radius: 0, angle: 0 }, gravity: [0.5, -4, 1] },
        ...{ render: 'mesh', particleGeometry: flag, ...settings },
      });
      emitter.rotation.set(0.4, 0.5, -0.9);
      emitter.step(0.6);
      scene.add(emitter);
      const image = bench.byTechnique('forward-single-pass', scene, camera);
      const { positions, velocities } = particles.texturesOf(emitter)!;
      const place = new three.Vector3().fromArray(readTexels(bench.webgl, positions));
      const velocity = new three.Vector3().fromArray(readTexels(bench.webgl, velocities));
      scene.remove(emitter);
      return { emitter, image, place, velocity };
    };
    /** Against a white mesh of three in its place; and lit, against a particle whose vertices and normals are turned. */
    const compare = (settings: Settings, wanted: (emitter: Object3D, velocity: Vector3) => Quaternion) => {
      const { emitter, image, place, velocity } = draw(settings);
      const turn = wanted(emitter, velocity);
      const mesh = new three.Mesh(emitter.particleGeometry!.clone(), new three.MeshBasicMaterial());
      mesh.position.copy(place);
      mesh.quaternion.copy(turn);
      scene.add(mesh);
      const stock = bench.stock(scene, camera);
      scene.remove(mesh);
      const geometry = emitter.particleGeometry!.clone().applyQuaternion(turn);
      const lit = draw({ ...settings, lit: true }).image;
      const plain = { orientation: 'random', initialRotation: [0, 0], particleGeometry: geometry, lit: true } as const;
      const turnedFirst = draw({ ...settings, ...plain }).image;
      return {
        flat: isFlat(stock),
        shape: compareImages(stock, image).share,
        shading: compareImages(turnedFirst, lit).share,
      };
    };
    const up = new three.Vector3(0, 1, 0);
    const still = () => new three.Quaternion();
    const asEmitter = ({ quaternion }: Object3D) => quaternion.clone();
    const along = (_: Object3D, velocity: Vector3) => still().setFromUnitVectors(up, velocity.normalize());
    const aboutUp = (angle: number) => still().setFromAxisAngle(up, angle);
    const turned = { initialRotation: [1.1, 1.1] } as const;
    const cases = {
      random: compare({ orientation: 'random' }, still),
      emitter: compare({ orientation: 'emitter' }, asEmitter),
      'emitter, turned': compare({ orientation: 'emitter', ...turned }, (emitter) =>
        asEmitter(emitter).multiply(aboutUp(1.1)),
      ),
      velocity: compare({ orientation: 'velocity', particleGeometry: cone }, along),
      'velocity, turned': compare({ orientation: 'velocity', particleGeometry: cone, ...turned }, along),
      'velocity, at rest': compare({ orientation: 'velocity', speed: [0, 0], gravity: [0, 0, 0] }, still),
    };
    // turned about an axis that is its own: not the emitter's +Y, and another one for another particle
    const one = draw({ orientation: 'random', ...turned }).image;
    const other = draw({ orientation: 'random', ...turned, seed: 4 }).image;
    const stands = draw({ orientation: 'emitter', ...turned }).image;
    return { cases, own: [compareImages(one, other).share, compareImages(one, stands).share] };
  });
  for (const [name, { flat, shape, shading }] of Object.entries(seen.cases)) {
    expect(flat, `${name}: nothing is seen`).toBe(false);
    expect.soft(shape, `${name}: where it is`).toBeLessThan(EDGES);
    expect.soft(shading, `${name}: its normals`).toBeLessThan(EDGES);
  }
  for (const share of seen.own) expect(share, 'turned about an axis of its own').toBeGreaterThan(10 * EDGES);
});
