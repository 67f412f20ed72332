import { checkAgreement } from '../support/agreement';
import { expect, test } from '../support/benchTest';

test('a canvas and a target that are seen through have the alpha of stock three, by each technique', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { alphaBench, alphaScene, compareImages, drawn, effects, techniquesInTurn } = window.testPage;
    const { bench, toCanvas } = alphaBench(144, 96);
    bench.farol.inferredScale = 1;
    const { scene, camera } = alphaScene(144, 96);
    return [0, 0.5].flatMap((clear) => {
      bench.webgl.setClearColor(0x886644, clear);
      const target = bench.stock(scene, camera);
      const canvas = toCanvas(() => bench.webgl.render(scene, camera));
      const values = new Set(target.data.filter((_, i) => i % 4 === 3)).size;
      return techniquesInTurn(3, drawn).map((technique) => {
        const difference = compareImages(target, bench.byTechnique(technique, scene, camera));
        const onCanvas = compareImages(
          canvas,
          toCanvas(() => bench.farol.render(scene, camera)),
        ).alpha;
        let occluded = 0;
        if (technique.includes('deferred')) {
          bench.farol.effects = [new effects.AmbientOcclusion()];
          occluded = compareImages(target, bench.byTechnique(technique, scene, camera)).alpha;
          bench.farol.effects = [];
        }
        return { name: `cleared to ${clear}`, technique, values, difference, onCanvas, occluded };
      });
    });
  });
  for (const { name, technique, values, difference, onCanvas, occluded } of results) {
    expect(values, 'values of alpha in stock three').toBeGreaterThan(5);
    checkAgreement(technique, difference, name);
    expect.soft(onCanvas, `${name}, ${technique}, canvas`).toBe(0);
    expect.soft(occluded, `${name}, ${technique}, with ambient occlusion`).toBe(0);
  }
});

test('smoothed edges over a canvas that is seen through are seen through in part, in no brighter colour', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { alphaBench, effects, three } = window.testPage;
    const { bench, toCanvas } = alphaBench(96, 64);
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(50, 1.5, 0.1, 30);
    camera.position.z = 4;
    // black and white: edges that are seen by alpha alone, and by colour too
    const balls = [0x000000, 0xffffff].map((color, i) => {
      const ball = new three.Mesh(new three.SphereGeometry(0.9, 48, 32), new three.MeshBasicMaterial({ color }));
      ball.position.x = i * 2 - 1;
      return ball;
    });
    scene.add(...balls);
    const { SMAA, TAA, MultisampledEdges } = effects;
    const alphasOf = (data: ArrayLike<number>) => Array.from({ length: data.length / 4 }, (_, i) => data[i * 4 + 3]);
    // share of each pixel that is covered, by 8 × 8 samples of it
    const fine = alphaBench(96 * 8, 64 * 8);
    const samples = alphasOf(fine.toCanvas(() => fine.bench.webgl.render(scene, camera)).data);
    const covered = Array.from({ length: 96 * 64 }, () => 0);
    samples.forEach((alpha, i) => {
      covered[Math.floor(i / (96 * 8) / 8) * 96 + Math.floor((i % (96 * 8)) / 8)] += alpha / 64;
    });
    return [null, new SMAA(), new TAA(), new MultisampledEdges()].map((effect) => {
      bench.farol.effects = effect ? [effect] : [];
      for (let i = 0; i < 16; i++) bench.farol.render(scene, camera);
      const { data } = toCanvas(() => bench.farol.render(scene, camera));
      let brighter = 0;
      const errors = [0, 0];
      alphasOf(data).forEach((alpha, i) => {
        for (let c = 0; c < 3; c++) brighter = Math.max(brighter, data[i * 4 + c] - alpha);
        errors[i % 96 < 48 ? 0 : 1] += Math.abs(alpha - covered[i]);
      });
      return { name: effect?.name ?? 'none', brighter, errors };
    });
  });
  const [none, ...smooth] = results;
  for (const { name, brighter, errors } of smooth) {
    expect.soft(brighter, `${name}: colour above alpha, which premultiplied colours never are`).toBeLessThan(1.5 / 255);
    errors.forEach((error, i) =>
      expect.soft(error / none.errors[i], `${name}: error of alpha, ${i ? 'white' : 'black'}`).toBeLessThan(0.8),
    );
  }
});

test('what moves leaves no alpha behind under TAA', async ({ benchPage: page }) => {
  const left = await page.evaluate(() => {
    const { alphaBench, effects, three } = window.testPage;
    const { bench, toCanvas } = alphaBench(96, 64);
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(50, 1.5, 0.1, 30);
    camera.position.z = 4;
    const ball = new three.Mesh(new three.SphereGeometry(0.6), new three.MeshBasicMaterial({ color: 0x666666 }));
    scene.add(ball);
    bench.farol.effects = [new effects.TAA()];
    for (let i = 0; i < 16; i++) {
      ball.position.x = i * 0.1 - 1.5;
      bench.farol.render(scene, camera);
    }
    const now = toCanvas(() => bench.farol.render(scene, camera)).data;
    ball.scale.setScalar(1.2);
    const near = toCanvas(() => bench.webgl.render(scene, camera)).data;
    let left = 0;
    for (let i = 3; i < now.length; i += 4) if (near[i] === 0) left = Math.max(left, now[i]);
    return left;
  });
  expect(left, 'alpha where nothing is').toBeLessThan(0.02);
});
