import { expect, test } from '../support/benchTest';

test('vertices that the CPU cannot read any more, or never could, throw and receive shadows as in stock three', async ({
  benchPage: page,
}) => {
  const frames = await page.evaluate(() => {
    const { Bench, compareImages, three } = window.testPage;
    const bench = new Bench(96, 64);
    bench.webgl.shadowMap.enabled = true;
    const gl = bench.webgl.getContext();
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(60, 1.5, 0.1, 50);
    camera.position.set(0, 6, 12);
    camera.lookAt(0, 0, 0);
    const material = new three.MeshStandardMaterial();
    /** As three's examples free what the GPU has. */
    const free = (geometry: import('three').BufferGeometry, empty: unknown) => {
      const drop = function (this: { array: unknown }) {
        this.array = empty;
      };
      for (const attribute of [...Object.values(geometry.attributes), geometry.index!])
        (attribute as import('three').BufferAttribute).onUpload(drop);
      return geometry;
    };
    const floor = new three.Mesh(free(new three.PlaneGeometry(24, 12), null), material);
    floor.rotation.x = -Math.PI / 2;
    floor.receiveShadow = true;
    // of more triangles than a frame puts in order
    const knot = new three.Mesh(free(new three.TorusKnotGeometry(0.8, 0.3, 1200, 70), null), material);
    const emptied = new three.Mesh(free(new three.BoxGeometry(1, 1, 1), new Float32Array(0)), material);
    const group = new three.InstancedMesh(free(new three.BoxGeometry(0.8, 0.8, 0.8), null), material, 2);
    group.setMatrixAt(0, new three.Matrix4().makeTranslation(0, 0, 2));
    group.setMatrixAt(1, new three.Matrix4().makeTranslation(0, 0, -2));
    const box = new three.BoxGeometry(1, 1.5, 1);
    const buffer = gl.createBuffer()!;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, box.attributes.position.array as Float32Array, gl.STATIC_DRAW);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    const onGPU = new three.BufferGeometry();
    onGPU.setAttribute('position', new three.GLBufferAttribute(buffer, gl.FLOAT, 3, 4, 24) as never);
    onGPU.setAttribute('normal', box.attributes.normal);
    onGPU.setIndex(box.index);
    onGPU.boundingSphere = new three.Sphere(new three.Vector3(), 2);
    const foreign = new three.Mesh(onGPU, material);
    const casters = [knot, emptied, group, foreign];
    casters.forEach((caster, i) => {
      caster.position.set(-6 + 4 * i, 1.5, 0);
      caster.castShadow = caster.receiveShadow = true;
    });
    const sun = new three.DirectionalLight(0xffffff, 1);
    sun.position.set(2, 8, 3);
    Object.assign(sun.shadow.camera, { left: -12, right: 12, top: 12, bottom: -12 });
    const spot = new three.SpotLight(0xffffff, 300, 20, 0.9);
    spot.position.set(0, 9, 2);
    for (const light of [sun, spot]) {
      light.castShadow = true;
      light.shadow.bias = -0.005;
      light.shadow.mapSize.set(256, 256);
    }
    scene.add(floor, ...casters, sun, spot);
    const results: { name: string; psnr: number; drawn: number }[] = [];
    for (const technique of ['forward-single-pass', 'deferred', 'forward'] as const) {
      for (let i = 0; i < 4; i++) {
        casters.forEach((caster) => (caster.rotation.y += 0.3));
        const image = bench.byTechnique(technique, scene, camera);
        const { psnr } = compareImages(bench.stock(scene, camera), image);
        results.push({ name: `${technique} ${i}`, psnr, drawn: bench.farol.info.shadows.drawn });
      }
    }
    // what stands on the GPU alone may change at any time
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new three.BoxGeometry(0.5, 3, 0.5).attributes.position.array, gl.STATIC_DRAW);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    const image = bench.byTechnique('forward-single-pass', scene, camera);
    const { psnr } = compareImages(bench.stock(scene, camera), image);
    results.push({ name: 'written to by the GPU', psnr, drawn: bench.farol.info.shadows.drawn });
    return results;
  });
  for (const { name, psnr, drawn } of frames) {
    expect.soft(psnr, name).toBeGreaterThan(60);
    expect.soft(drawn, name).toBe(2);
  }
});
