import { expect, test } from '../support/benchTest';

test('a field by textures, in several renderers and by several cameras at once, after a lost context', async ({
  benchPage: page,
  watch,
}) => {
  const results = await page.evaluate(async () => {
    const { Bench, compareImages, countGpuObjects, lightFields, three } = window.testPage;
    const alive = countGpuObjects();
    const bench = new Bench(64, 48);
    const scene = new three.Scene();
    scene.add(new three.Mesh(new three.PlaneGeometry(12, 12), new three.MeshStandardMaterial()));
    const camera = new three.PerspectiveCamera(60, 64 / 48, 0.1, 30);
    camera.position.z = 7;
    const field = new lightFields.LightField(90);
    const lights = new three.Group();
    // rows of 7 lights, as the GPU may write them, in half floats
    const spheres = new Float32Array(7 * 13 * 4);
    const emissions = new Uint16Array(7 * 13 * 4);
    for (let i = 0; i < 90; i++) {
      const [x, y, z, range] = [(i % 10) - 4.5, Math.floor(i / 10) - 4, 0.5, 1.5];
      field.setPoint(i, x, y, z, range, 0.25, i / 180, 0.5);
      spheres.set([x, y, z, range], i * 4);
      emissions.set([0.25, i / 180, 0.5, 2].map(three.DataUtils.toHalfFloat), i * 4);
      const light = new three.PointLight(new three.Color(0.25, i / 180, 0.5), 1, range);
      light.position.set(x, y, z);
      lights.add(light);
    }
    const texture = (data: Float32Array | Uint16Array, type: typeof three.FloatType | typeof three.HalfFloatType) => {
      const made = new three.DataTexture(data, 7, 13, three.RGBAFormat, type);
      made.needsUpdate = true;
      return made;
    };
    const textures = { sphere: texture(spheres, three.FloatType), emission: texture(emissions, three.HalfFloatType) };
    const written = new lightFields.LightField(90, { textures });
    const draw = (
      content: InstanceType<typeof three.Object3D>,
      by = bench,
      view: InstanceType<typeof three.Camera> = camera,
    ) => {
      scene.add(content);
      const picture = by.byTechnique('tiled-deferred', scene, view);
      content.removeFromParent();
      return picture;
    };
    const alone = draw(lights);
    const far: Record<string, number> = {};
    const check = (name: string, picture: ReturnType<typeof draw>, expected = alone) => {
      far[name] = compareImages(expected, picture).largest;
    };
    check('arrays', draw(field));
    check('textures', draw(written));
    const other = new Bench(64, 48, { losesContext: true });
    check('another renderer', draw(field, other));
    field.setEmission(0, 1, 1, 1);
    (lights.children[0] as InstanceType<typeof three.PointLight>).color.setRGB(1, 1, 1);
    const changed = draw(lights);
    check('a change, in the one', draw(field), changed);
    check('a change, in the other', draw(field, other), changed);
    const halves = [0, 32].map((x) => {
      const half = camera.clone();
      half.rotation.y = x / 100;
      half.updateMatrixWorld();
      return Object.assign(half, { viewport: new three.Vector4(x, 0, 32, 48) });
    });
    const both = new three.ArrayCamera(halves);
    check('two cameras', draw(field, bench, both), draw(lights, bench, both));
    bench.farol.view = 'light-count';
    check('counts', draw(field), draw(lights));
    bench.farol.view = 'final';
    await other.loseContext();
    check('after a loss', draw(field, other), changed);
    field.castShadow = true;
    draw(field);
    draw(field);
    draw(written);
    const before = alive().Texture;
    field.dispose();
    const freed = before - alive().Texture;
    for (const { farol } of [bench, other]) farol.dispose();
    return { far, freed };
  });
  expect(watch.forgive(/a WebGL context was lost|Context Lost|Context Restored/i)).toBeGreaterThan(0);
  expect(watch.forgive(/has castShadow, but its lights cast no shadows/)).toBe(1);
  // half floats round emissions to 11 bits; all else is the rounding of sums in another order
  for (const [name, far] of Object.entries(results.far))
    expect(far, name).toBeLessThan(name === 'textures' ? 2e-3 : 1e-4);
  // positions and emissions in both renderers, and the emissions from before the change
  expect(results.freed).toBe(5);
});
