import { isWhole } from '@farol/tools/extent';
import { expect, test } from '../support/benchTest';

test('under TAA particles leave no trail', async ({ benchPage: page }) => {
  const seen = await page.evaluate((isWhole) => {
    const { Bench, edgeScene, effects, oneParticle, three } = window.testPage;
    const [width, height] = [96, 64];
    const bench = new Bench(width, height);
    const { scene, camera } = edgeScene(width, height);
    const plain = new three.DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);
    plain.needsUpdate = true;
    // one that flies across the upper half of the picture
    const emitter = oneParticle({
      speed: [4, 4],
      shape: { kind: 'cone', radius: 0, angle: 0 },
      size: [0.7, 0.7],
      colorOverLife: [[0, [4, 0.2, 4], 1]],
      texture: plain,
    });
    const ahead = camera.getWorldDirection(new three.Vector3());
    const right = new three.Vector3(1, 0, 0).applyQuaternion(camera.quaternion);
    const up = new three.Vector3(0, 1, 0).applyQuaternion(camera.quaternion);
    emitter.position.copy(camera.position).addScaledVector(ahead, 3);
    emitter.position.addScaledVector(right, -1.6).addScaledVector(up, 0.5);
    emitter.quaternion.setFromUnitVectors(new three.Vector3(0, 1, 0), right);
    const particles = new effects.Particles();
    const taa = new effects.TAA();
    const run = (withParticle: boolean, frames: number, move: (frame: number) => void) => {
      bench.farol.effects = [particles, taa];
      if (withParticle) scene.add(emitter);
      else scene.remove(emitter);
      emitter.restart();
      taa.reset();
      let image!: ReturnType<typeof bench.byTechnique>;
      for (let i = 0; i < frames; i++) {
        move(i);
        emitter.step(1 / 60);
        image = bench.byTechnique('deferred', scene, camera);
      }
      scene.remove(emitter);
      return image.data;
    };
    const at = (camera.position as { x: number }).x;
    const moves: Record<string, (frame: number) => void> = {
      'a camera that stands': () => {},
      'a camera that moves': (frame) => (camera.position.x = at + 0.01 * frame),
    };
    // where the camera moves, all of the past is looked up elsewhere
    return Object.entries(moves)
      .slice(isWhole ? 0 : 1)
      .map(([name, move]) => {
        const without = run(false, 30, move);
        const seen = run(true, 30, move);
        bench.farol.effects = [particles];
        scene.add(emitter);
        const now = bench.byTechnique('deferred', scene, camera).data;
        scene.remove(emitter);
        const alone = bench.byTechnique('deferred', scene, camera).data;
        // columns that the particle covers now, with those beside it
        const covered = new Set<number>();
        for (let i = 0; i < width * height; i++)
          if ([0, 1, 2].some((c) => Math.abs(now[4 * i + c] - alone[4 * i + c]) > 0.01))
            for (let k = -3; k <= 3; k++) covered.add((i % width) + k);
        // how much of the particle's colour, red and blue, is where the scene has it nowhere round the pixel
        let trail = 0;
        let particle = 0;
        for (let i = 0; i < width * height; i++) {
          // edges whose past is gone show single samples: of no colour, the particle's trail is of its own
          const [red, green, blue] = [0, 1, 2].map((c) => {
            let high = alone[4 * i + c];
            for (let y = -1; y <= 1; y++)
              for (let x = -1; x <= 1; x++) {
                const at = 4 * (i + y * width + x) + c;
                if (at in alone) high = Math.max(high, alone[at], without[at]);
              }
            return Math.max(seen[4 * i + c] - high, 0);
          });
          const off = Math.min(red, blue) - green;
          if (covered.has(i % width)) particle = Math.max(particle, off);
          else trail = Math.max(trail, off);
        }
        return { name, trail, particle, covered: covered.size };
      });
  }, isWhole);
  test.info().annotations.push({ type: 'trails', description: JSON.stringify(seen) });
  for (const { name, trail, particle, covered } of seen) {
    expect(covered, name).toBeGreaterThan(10);
    expect(covered, name).toBeLessThan(60);
    expect(particle, name).toBeGreaterThan(1);
    expect(trail, name).toBeLessThan(0.02);
  }
});
