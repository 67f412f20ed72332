import { expect, test } from '../support/benchTest';

test('vertices that the CPU cannot read any more, or never could, throw and receive shadows as in stock three', async ({
  benchPage: page,
}) => {
  const frames = await page.evaluate(() => {
    const { Bench, compareImages, isSlice, three } = window.testPage;
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
    Object.assign(sun.shadow.camera, { left: -12, right: 12, top: 12, bottom: -12, far: 30 }).updateProjectionMatrix();
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
        // the knot alone is 168,000 triangles, drawn for two maps and the picture, by both renderers
        if (isSlice && i % 3 > 0) continue;
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

test('shadows follow interleaved vertices that are moved or replaced, also instances and morphs that are', async ({
  benchPage: page,
}) => {
  const steps = await page.evaluate(() => {
    const { Bench, compareImages, three } = window.testPage;
    const bench = new Bench(96, 64);
    bench.webgl.shadowMap.enabled = true;
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(60, 1.5, 0.1, 50);
    camera.position.set(0, 6, 12);
    camera.lookAt(0, 0, 0);
    const material = new three.MeshStandardMaterial();
    const floor = new three.Mesh(new three.PlaneGeometry(24, 12), material);
    floor.rotation.x = -Math.PI / 2;
    floor.receiveShadow = true;
    /** A box whose positions and normals share a buffer. */
    const interleaved = (width: number, x: number) => {
      const { position, normal } = new three.BoxGeometry(width, 1.5, 1).translate(x, 0, 0).attributes;
      const data = new Float32Array(position.count * 6);
      for (let i = 0; i < position.count; i++) {
        data.set([position.getX(i), position.getY(i), position.getZ(i)], 6 * i);
        data.set([normal.getX(i), normal.getY(i), normal.getZ(i)], 6 * i + 3);
      }
      return new three.InterleavedBuffer(data, 6);
    };
    const geometry = new three.BufferGeometry();
    const take = (buffer: import('three').InterleavedBuffer) => {
      geometry.setAttribute('position', new three.InterleavedBufferAttribute(buffer, 3, 0));
      geometry.setAttribute('normal', new three.InterleavedBufferAttribute(buffer, 3, 3));
    };
    const buffer = interleaved(1, -4);
    take(buffer);
    geometry.setIndex(new three.BoxGeometry().index);
    geometry.boundingSphere = new three.Sphere(new three.Vector3(), 9);
    const box = new three.Mesh(geometry, material);
    box.position.y = 1.5;
    const matrices = (z: number) => {
      const attribute = new three.InstancedBufferAttribute(new Float32Array(32), 16);
      [0, 4].forEach((x, i) => new three.Matrix4().makeTranslation(x, 0, z).toArray(attribute.array, 16 * i));
      return attribute;
    };
    const group = new three.InstancedMesh(new three.BoxGeometry(0.6, 0.6, 0.6), material, 2);
    group.instanceMatrix = matrices(3);
    group.boundingSphere = new three.Sphere(new three.Vector3(), 9);
    for (const caster of [box, group]) caster.castShadow = caster.receiveShadow = true;
    const sun = new three.DirectionalLight(0xffffff, 1);
    sun.position.set(2, 8, 3);
    sun.castShadow = true;
    sun.shadow.bias = -0.005;
    sun.shadow.mapSize.set(256, 256);
    Object.assign(sun.shadow.camera, { left: -12, right: 12, top: 12, bottom: -12, far: 30 }).updateProjectionMatrix();
    scene.add(floor, box, group, sun);
    const step = (name: string, change: () => void) => {
      change();
      const image = bench.byTechnique('forward-single-pass', scene, camera);
      const { drawn } = bench.farol.info.shadows;
      return { name, drawn, psnr: compareImages(bench.stock(scene, camera), image).psnr };
    };
    const results = [
      step('first', () => {}),
      step('at rest', () => {}),
      step('data.needsUpdate', () => {
        buffer.array.set(interleaved(2, -3).array);
        buffer.needsUpdate = true;
      }),
      step('another buffer of as many vertices', () => take(interleaved(1, 4))),
      step('other instances', () => (group.instanceMatrix = matrices(-2))),
    ];
    // its receiver's box is of the vertices as they are
    for (let i = 0; i < 3; i++) {
      results.push(
        step(`moves on, ${i}`, () => {
          take(interleaved(2, 4 - 3 * i));
          group.rotation.y += 0.1;
        }),
      );
    }
    return results;
  });
  for (const { name, drawn, psnr } of steps) {
    expect.soft(psnr, name).toBeGreaterThan(60);
    expect.soft(drawn, name).toBe(name === 'at rest' ? 0 : 1);
  }
});

test('a ground that the page bends shows shadows wherever it is bent to, while things move and at rest', async ({
  benchPage: page,
}) => {
  const frames = await page.evaluate(() => {
    const { Bench, compareImages, three } = window.testPage;
    const bench = new Bench(96, 64);
    bench.webgl.shadowMap.enabled = true;
    const camera = new three.PerspectiveCamera(60, 1.5, 0.1, 50);
    camera.position.set(0, 6, 12);
    camera.lookAt(0, 0, 0);
    const tile = () => new three.PlaneGeometry(2, 2, 8, 8).rotateX(-Math.PI / 2);
    const white = () => new three.MeshStandardMaterial();
    const grounds: Record<string, () => import('three').Mesh> = {
      'made larger in onBeforeCompile': () => {
        const material = white();
        material.onBeforeCompile = (shader) => {
          const { vertexShader } = shader;
          shader.vertexShader = vertexShader.replace(
            '#include <begin_vertex>',
            'vec3 transformed = vec3(12.0 * position.x, 0.3 * sin(9.0 * position.x), 6.0 * position.z);',
          );
        };
        return new three.Mesh(tile(), material);
      },
      'tiles by instances': () => {
        const geometry = new three.InstancedBufferGeometry();
        const one = tile();
        for (const [name, attribute] of Object.entries(one.attributes)) geometry.setAttribute(name, attribute);
        geometry.setIndex(one.index);
        const places = Array.from({ length: 72 }, (_, i) => [2 * (i % 12) - 11, 0, 2 * Math.floor(i / 12) - 5]);
        geometry.setAttribute('place', new three.InstancedBufferAttribute(new Float32Array(places.flat()), 3));
        geometry.instanceCount = places.length;
        const material = white();
        material.onBeforeCompile = (shader) => {
          const { vertexShader } = shader;
          shader.vertexShader = `attribute vec3 place;\n${vertexShader}`.replace(
            '#include <begin_vertex>',
            'vec3 transformed = position + place;',
          );
        };
        return new three.Mesh(geometry, material);
      },
      'a ShaderMaterial with lights': () => {
        const { uniforms, vertexShader, fragmentShader } = three.ShaderLib.lambert;
        const material = new three.ShaderMaterial({
          uniforms: three.UniformsUtils.clone(uniforms),
          vertexShader: vertexShader.replace(
            '#include <begin_vertex>',
            'vec3 transformed = vec3(12.0 * position.x, 0.0, 6.0 * position.z);',
          ),
          fragmentShader,
          lights: true,
        });
        material.uniforms.diffuse.value.set(0xffffff);
        return new three.Mesh(tile(), material);
      },
    };
    const results: { name: string; psnr: number; shadow: number }[] = [];
    for (const [kind, make] of Object.entries(grounds)) {
      for (const technique of ['forward-single-pass', 'forward', 'deferred', 'tiled-deferred'] as const) {
        const scene = new three.Scene();
        const ground = make();
        const box = new three.Mesh(new three.BoxGeometry(1, 1, 1), white());
        box.castShadow = ground.receiveShadow = true;
        const sun = new three.DirectionalLight(0xffffff, 1);
        sun.position.set(2, 8, 3);
        Object.assign(sun.shadow.camera, {
          left: -12,
          right: 12,
          top: 12,
          bottom: -12,
          far: 30,
        }).updateProjectionMatrix();
        const lamp = new three.PointLight(0xffffff, 60, 20);
        lamp.position.set(-4, 5, 1);
        for (const light of [sun, lamp]) {
          light.castShadow = true;
          light.shadow.bias = -0.005;
          light.shadow.mapSize.set(256, 256);
        }
        scene.add(ground, box, sun, lamp);
        for (let i = 0; i < 5; i++) {
          if (i < 4) box.position.set(-6 + i, 1.5, -1);
          const image = bench.byTechnique(technique, scene, camera);
          const stock = bench.stock(scene, camera);
          ground.receiveShadow = false;
          const bare = i === 4 ? compareImages(stock, bench.stock(scene, camera)).psnr : 0;
          ground.receiveShadow = true;
          const name = `${kind}, ${technique}, ${i < 4 ? `moves ${i}` : 'at rest'}`;
          results.push({ name, psnr: compareImages(stock, image).psnr, shadow: bare });
        }
      }
    }
    return results;
  });
  for (const { name, psnr, shadow } of frames) {
    expect.soft(psnr, name).toBeGreaterThan(55);
    expect.soft(shadow, `${name}: there is a shadow`).toBeLessThan(45);
  }
});
