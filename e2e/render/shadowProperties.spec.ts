import { expect, test } from '../support/test';

test("shadow cameras and matrices are what stock three leaves, and three's helpers and viewers show them", async ({
  page,
  pagesURL,
}) => {
  await page.goto(pagesURL);
  await page.waitForFunction(() => 'testPage' in window);
  const seen = await page.evaluate(() => {
    const { Bench, compareImages, isFlat, shadowScene, three: THREE } = window.testPage;
    const bench = new Bench(96, 72);
    const { webgl } = bench;
    webgl.shadowMap.enabled = true;
    bench.farol.technique = 'forward-single-pass';
    const results: { name: string; farol: string; stock: string }[] = [];
    /** What is left of each light's shadow. */
    const left = (lights: readonly import('three').Light[]) =>
      lights.map((light) => {
        const { camera, matrix } = light.shadow!;
        const { far, near, up, quaternion, position } = camera as import('three').PerspectiveCamera;
        const matrices = [camera.matrix, camera.matrixWorld, camera.matrixWorldInverse, camera.projectionMatrix, matrix]; // prettier-ignore
        const numbers = matrices.flatMap(({ elements }) => [...elements]);
        numbers.push(far, near, (camera as import('three').PerspectiveCamera).fov ?? 0, ...up, ...position, ...quaternion.toArray()); // prettier-ignore
        return numbers.map((number) => (Math.round(number * 1e5) / 1e5 + 0).toString()).join(' ');
      });
    const steps = {
      'at first': () => {},
      'moved and turned': (lights: readonly import('three').Light[]) => {
        for (const light of lights) light.position.x += 0.5;
        (lights[0] as import('three').SpotLight).angle = 0.4;
        (lights[1] as import('three').PointLight).distance = 9;
      },
      'with other frusta': (lights: readonly import('three').Light[]) => {
        for (const { shadow } of lights) {
          Object.assign(shadow!.camera, { near: 0.7 });
          (shadow!.camera as import('three').PerspectiveCamera).updateProjectionMatrix();
        }
      },
    };
    const scenes = [0, 1].map(() => shadowScene(96, 72, { caster: 'mixed' }));
    for (const [name, change] of Object.entries(steps)) {
      const [byFarol, byThree] = scenes.map(({ scene, camera, lights }, i) => {
        change(lights);
        (i === 0 ? bench.farol : webgl).render(scene, camera);
        return left(lights);
      });
      byFarol.forEach((farol, i) => results.push({ name: `${name}, light ${i}`, farol, stock: byThree[i] }));
    }
    // the common idiom: a helper made before anything is drawn
    const helped = (by: 'farol' | 'three') => {
      const { scene, camera, lights } = shadowScene(96, 72, { caster: 'spot' });
      const helper = new THREE.CameraHelper(lights[0].shadow!.camera);
      scene.add(helper);
      const draw = () => (by === 'farol' ? bench.byTechnique('deferred', scene, camera) : bench.stock(scene, camera));
      draw();
      helper.update();
      return draw();
    };
    const helper = compareImages(helped('three'), helped('farol')).psnr;
    void isFlat;
    return { results, helper };
  });
  expect(seen.results.length).toBe(15);
  for (const { name, farol, stock } of seen.results) expect.soft(farol, name).toBe(stock);
  expect(seen.helper, 'a CameraHelper (dB)').toBeGreaterThan(45);
});
