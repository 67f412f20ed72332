import { expect, test } from '../support/test';

test('views of surfaces show the values of material and place', async ({ benchPage: page }) => {
  const seen = await page.evaluate(() => {
    const { Bench, three } = window.testPage;
    const size = 9;
    const bench = new Bench(size, size);
    const color = new three.Color(0.2, 0.4, 0.6);
    const emissive = new three.Color(0.1, 0.05, 0.2);
    const materials = {
      standard: new three.MeshStandardMaterial({ color, emissive, roughness: 0.4, metalness: 0.8 }),
      phong: new three.MeshPhongMaterial({ color, emissive, shininess: 30 }),
    };
    const plane = new three.Mesh(new three.PlaneGeometry(50, 50));
    plane.position.set(1.5, 2.5, -3);
    plane.rotation.y = 0.5;
    const scene = new three.Scene().add(plane);
    const perspective = new three.PerspectiveCamera(50, 1, 1, 100);
    const orthographic = new three.OrthographicCamera(-1, 1, 1, -1, 1, 17);
    const views = ['albedo', 'normal', 'depth', 'position', 'roughness', 'metalness', 'emissive'] as const;
    const values: Record<string, number[]> = {};
    for (const [kind, material] of Object.entries(materials)) {
      plane.material = material;
      for (const camera of kind === 'phong' ? [perspective] : [perspective, orthographic]) {
        camera.position.set(1.5, 2.5, 5);
        for (const view of views) {
          bench.farol.view = view;
          const { data } = bench.byTechnique('forward-single-pass', scene, camera);
          const middle = 4 * ((size * size - 1) / 2);
          values[`${kind}, ${view}${camera === orthographic ? ', orthographic' : ''}`] = [...data].slice(
            middle,
            middle + 3,
          );
        }
      }
    }
    return values;
  });
  const albedo = [0.2, 0.4, 0.6];
  const emissive = [0.1, 0.05, 0.2];
  const normal = [Math.sin(0.5) / 2 + 0.5, 0.5, Math.cos(0.5) / 2 + 0.5];
  // a tenth of the place in the world, from 0 to 1 and again
  const position = [0.15, 0.25, 0.7];
  const grey = (value: number) => [value, value, value];
  // by logarithms from near to far; 8 m before the camera
  const depth = grey(Math.log(8) / Math.log(100));
  const surface = { albedo, normal, depth, position, emissive };
  const expected: Record<string, Record<string, number[]>> = {
    standard: { ...surface, roughness: grey(0.4), metalness: grey(0.8) },
    // Blinn-Phong's alpha² is 2 / (shininess + 2)
    phong: { ...surface, roughness: grey((2 / 32) ** 0.25), metalness: grey(0) },
  };
  expect(Object.keys(seen)).toHaveLength(21);
  for (const [name, value] of Object.entries(seen)) {
    const [kind, view, camera] = name.split(', ');
    const wanted = view === 'depth' && camera === 'orthographic' ? grey(7 / 16) : expected[kind][view];
    // 8 bits hold albedo in sRGB, half a step of which is 0.0037 at 0.6, roughness and metalness; half floats the rest
    value.forEach((channel, i) => expect.soft(Math.abs(channel - wanted[i]), `${name}: ${value}`).toBeLessThan(0.0038));
  }
});
