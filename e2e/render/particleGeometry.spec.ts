import { expect, test } from '../support/benchTest';

test("the geometry of mesh particles stays the host's: drawn by a mesh, disposed of, each without the other", async ({
  benchPage: page,
}) => {
  const pictures = await page.evaluate(() => {
    const { Bench, effects, three } = window.testPage;
    const bench = new Bench(48, 32);
    bench.farol.effects = [new effects.Particles()];
    const scene = new three.Scene();
    scene.background = new three.Color(0, 0, 0);
    const camera = new three.PerspectiveCamera(45, 48 / 32, 0.1, 20);
    camera.position.z = 4;
    const plain = new three.TorusGeometry(0.7, 0.3, 8, 12);
    return [plain, plain.toNonIndexed()].map((geometry) => {
      const mesh = new three.Mesh(geometry, new three.MeshNormalMaterial());
      const emitter = new effects.ParticleEmitter({
        ...{ capacity: 4, rate: 0, bursts: [{ time: 0, count: 1 }], life: [9, 9], speed: [0, 0], size: [1, 1] },
        ...{ render: 'mesh', particleGeometry: geometry },
      });
      scene.add(mesh);
      const draw = () => [...bench.byTechnique('forward-single-pass', scene, camera).data];
      const meshAlone = draw();
      scene.remove(mesh);
      scene.add(emitter);
      emitter.step(0.1);
      const emitterAlone = draw();
      geometry.dispose();
      const emitterLeft = draw();
      scene.remove(emitter);
      scene.add(mesh);
      draw();
      emitter.dispose();
      const meshLeft = draw();
      scene.clear();
      return { meshAlone, emitterAlone, emitterLeft, meshLeft };
    });
  });
  for (const { meshAlone, emitterAlone, emitterLeft, meshLeft } of pictures) {
    expect(Math.max(...meshAlone)).toBeGreaterThan(0.5);
    expect(emitterAlone.filter((value, i) => i % 4 < 3 && value > 0.1).length).toBeGreaterThan(50);
    expect(emitterLeft).toEqual(emitterAlone);
    expect(meshLeft).toEqual(meshAlone);
  }
});
