import { expect, test } from '../support/benchTest';

test("'forward' draws a light that reaches everything, or much of the picture, together with ambient light", async ({
  benchPage: page,
}) => {
  const draws = await page.evaluate(() => {
    const { Bench, three } = window.testPage;
    const bench = new Bench(64, 64);
    const scene = new three.Scene();
    scene.add(new three.Mesh(new three.PlaneGeometry(4, 4), new three.MeshStandardMaterial()));
    const camera = new three.PerspectiveCamera(50, 1, 0.1, 20);
    camera.position.z = 4;
    const point = (range: number) => {
      const light = new three.PointLight(0xffffff, 2, range);
      light.position.set(0, 0, 0.1);
      return light;
    };
    const sun = () => new three.DirectionalLight();
    const cases = {
      'no light': [],
      sun: [sun()],
      'a light without a range': [point(0)],
      'a large light': [point(5)],
      'a small light': [point(0.2)],
      'two suns': [sun(), sun()],
      'a sun, a large and a small light': [sun(), point(5), point(0.2)],
      'two large lights and a small one': [point(5), point(4), point(0.2)],
    };
    const draws: Record<string, number> = {};
    for (const [name, lights] of Object.entries(cases)) {
      for (const light of lights) scene.add(light);
      // the first frame compiles what adds a light, over no pixels
      for (let i = 0; i < 2; i++) bench.byTechnique('forward', scene, camera);
      draws[name] = bench.farol.info.passes.find(({ name }) => name === 'multipass lights')!.drawCalls;
      for (const light of lights) scene.remove(light);
    }
    return draws;
  });
  expect(draws).toEqual({
    'no light': 1,
    sun: 1,
    'a light without a range': 1,
    'a large light': 1,
    'a small light': 2,
    'two suns': 2,
    'a sun, a large and a small light': 3,
    'two large lights and a small one': 3,
  });
});
