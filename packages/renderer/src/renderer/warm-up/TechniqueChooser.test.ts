import { describe, expect, it } from 'vitest';
import { TechniqueChooser, type SceneFigures } from './TechniqueChooser';

const scene = (figures: Partial<SceneFigures>): SceneFigures => ({
  bounded: 60,
  everywhere: 1,
  coverage: 1,
  objects: 100,
  transparents: false,
  floatTargets: true,
  surfaces: false,
  ...{ pixels: 1920 * 1080, multisampled: false, overdraw: 0, triangles: 0 },
  ...figures,
});

describe('TechniqueChooser', () => {
  const few = scene({ bounded: 1, everywhere: 0 });
  const many = scene({ bounded: 50, coverage: 30 });
  const frames = (chooser: TechniqueChooser, count: number, figures: SceneFigures) =>
    Array.from({ length: count }, () => chooser.choose(figures).technique);
  /** Techniques of frames where a technique is ready as soon as it is asked for. */
  const readyFrames = (chooser: TechniqueChooser, count: number, figures: SceneFigures) => {
    Object.defineProperty(chooser, 'preparation', { get: () => ({ ready: true }), set: () => {} });
    return frames(chooser, count, figures);
  };

  it('takes lists from three lights on, and a G-buffer where many lie over a pixel', () => {
    expect(new TechniqueChooser().choose(scene({ bounded: 1, everywhere: 1 })).technique).toBe('forward-single-pass');
    expect(new TechniqueChooser().choose(scene({ bounded: 2 })).technique).toBe('clustered-forward');
    expect(new TechniqueChooser().choose(scene({ coverage: 20 })).technique).toBe('clustered-deferred');
    expect(new TechniqueChooser().choose(scene({ bounded: 1000, coverage: 20 })).technique).toBe('tiled-deferred');
  });

  it('takes lists made on the GPU for many small lights, and for very many of any size', () => {
    const over = (bounded: number, coverage: number) =>
      new TechniqueChooser().choose(scene({ bounded, coverage })).technique;
    expect([over(56, 10), over(106, 13), over(206, 16)]).toEqual([
      'clustered-deferred',
      'tiled-deferred',
      'tiled-deferred',
    ]);
    expect([over(100, 30), over(195, 46), over(205, 46)]).toEqual([
      'clustered-deferred',
      'clustered-deferred',
      'tiled-deferred',
    ]);
  });

  it('leaves a loop over all lights at once, prepared or not, where a settled scene gets more than it can bear', () => {
    const chooser = new TechniqueChooser();
    frames(chooser, 20, few);
    expect(frames(chooser, 1, scene({ bounded: 128, everywhere: 0 }))).toEqual(['forward-single-pass']);
    expect(frames(chooser, 1, scene({ bounded: 10_000, coverage: 30 }))).toEqual(['tiled-deferred']);
    expect(chooser.isChanging).toBe(false);
  });

  it.each([
    // at the last value for one technique, and above it
    [
      'lights',
      { bounded: 2, everywhere: 0 },
      'forward-single-pass',
      { bounded: 3, everywhere: 0 },
      'clustered-forward',
    ],
    ['lights over a pixel', { coverage: 2 }, 'clustered-forward', { coverage: 2.01 }, 'clustered-deferred'],
    [
      'small lights',
      { bounded: 90, coverage: 9 },
      'clustered-deferred',
      { bounded: 91, coverage: 9 },
      'tiled-deferred',
    ],
    [
      'the size of lights',
      { bounded: 200, coverage: 25.1 },
      'clustered-deferred',
      { bounded: 200, coverage: 25 },
      'tiled-deferred',
    ],
    [
      'large lights',
      { bounded: 200, coverage: 60 },
      'clustered-deferred',
      { bounded: 201, coverage: 60 },
      'tiled-deferred',
    ],
    [
      'lights over objects that take the CPU longer than the GPU',
      { bounded: 60, coverage: 30, objects: 1000 },
      'clustered-deferred',
      { bounded: 60, coverage: 30, objects: 1001 },
      'tiled-deferred',
    ],
    [
      'lights over many objects',
      { bounded: 50, coverage: 30, objects: 2000 },
      'clustered-deferred',
      { bounded: 51, coverage: 30, objects: 2000 },
      'tiled-deferred',
    ],
  ] as const)('changes at a bound that was measured: %s', (_, at, technique, beyond, other) => {
    expect(new TechniqueChooser().choose(scene(at)).technique).toBe(technique);
    expect(new TechniqueChooser().choose(scene(beyond)).technique).toBe(other);
  });

  it('takes lists from five lights on over few objects, which hardly hide one another', () => {
    const over = (objects: number, bounded: number) =>
      new TechniqueChooser().choose(scene({ objects, bounded, everywhere: 0 })).technique;
    expect([over(8, 4), over(8, 5), over(9, 4)]).toEqual([
      'forward-single-pass',
      'clustered-forward',
      'clustered-forward',
    ]);
  });

  it('takes lists that hold for what is transparent too, where such things are', () => {
    const figures = scene({ bounded: 1000, coverage: 20, transparents: true });
    expect(new TechniqueChooser().choose(figures).technique).toBe('clustered-deferred');
  });

  it.each([
    // figures of the Lab's scenes, and whether 'forward-plus' was faster on an H200
    ['the atrium', { bounded: 20, coverage: 5.7, overdraw: 1, triangles: 237_000 }, [false, true, true]],
    [
      'the atrium with 100 lights',
      { bounded: 100, coverage: 30, overdraw: 1, triangles: 244_000 },
      [false, false, true],
    ],
    [
      'the atrium with 500 lights',
      { bounded: 487, coverage: 84, overdraw: 1, triangles: 276_000 },
      [false, false, false],
    ],
    ['the temple', { bounded: 26, coverage: 8.2, overdraw: 0.23, triangles: 149_000 }, [false, false, false]],
    ['16 layers, back to front', { bounded: 100, coverage: 5, overdraw: 15, triangles: 34 }, [true, true, true]],
    ['one layer', { bounded: 100, coverage: 5, overdraw: 0, triangles: 4 }, [false, false, false]],
    [
      'objects side by side',
      { bounded: 100, coverage: 5.2, overdraw: 0.42, triangles: 228_000 },
      [false, false, false],
    ],
  ] as const)(
    'draws depth first where that saves more shading than it costs: %s, at 0.9, 2.1 and 8.3 million pixels',
    (_, figures, depth) => {
      const techniques = [1280 * 720, 1920 * 1080, 3840 * 2160].map(
        (pixels) => new TechniqueChooser().choose(scene({ ...figures, pixels })).technique,
      );
      expect(techniques.map((technique) => technique === 'forward-plus')).toEqual(depth);
    },
  );

  it('draws depth first neither into several samples a pixel, nor before lit transparent things or under effects of a G-buffer', () => {
    const over = (figures: Partial<SceneFigures>) =>
      new TechniqueChooser().choose(scene({ coverage: 5, overdraw: 15, ...figures })).technique;
    expect(over({})).toBe('forward-plus');
    expect(over({ floatTargets: false })).toBe('forward-plus');
    for (const figures of [{ multisampled: true }, { transparents: true }, { surfaces: true }]) {
      expect(over(figures)).toBe('clustered-deferred');
    }
    expect(over({ pixels: 128 * 128 }), 'a small picture').toBe('clustered-deferred');
    expect(over({ bounded: 1, coverage: 1 }), 'beside one light').toBe('forward-plus');
  });

  it('leaves the depth pre-pass at once for an effect that works on a G-buffer, and for good where overdraw goes', () => {
    const chooser = new TechniqueChooser();
    const layered = scene({ coverage: 5, overdraw: 15 });
    frames(chooser, 20, layered);
    expect(frames(chooser, 1, { ...layered, surfaces: true })).toEqual(['clustered-deferred']);
    const other = new TechniqueChooser();
    frames(other, 20, layered);
    const after = readyFrames(other, 20, { ...layered, overdraw: 0 });
    expect(after.indexOf('clustered-deferred')).toBe(7);
  });

  it('takes a G-buffer at once when an effect works on it, however few the lights', () => {
    const chooser = new TechniqueChooser();
    expect(chooser.choose(scene({ bounded: 0 })).technique).toBe('forward-single-pass');
    expect(chooser.choose(scene({ bounded: 0, surfaces: true })).technique).toBe('clustered-deferred');
    expect(chooser.choose(scene({ bounded: 0, surfaces: true, floatTargets: false })).technique).toBe(
      'forward-single-pass',
    );
  });

  it('never takes a G-buffer without float targets, and leaves it at once when they go', () => {
    const chooser = new TechniqueChooser();
    expect(new TechniqueChooser().choose(scene({ coverage: 20, floatTargets: false })).technique).toBe(
      'clustered-forward',
    );
    chooser.choose(scene({ coverage: 20 }));
    expect(chooser.choose(scene({ coverage: 20, floatTargets: false })).technique).toBe('clustered-forward');
  });

  it('does not flicker round the bound, and follows a lasting change after some frames', () => {
    const chooser = new TechniqueChooser();
    const first = chooser.choose(scene({ coverage: 1.9 })).technique;
    const seen = new Set<string>();
    for (let i = 0; i < 100; i++) seen.add(chooser.choose(scene({ coverage: i % 2 ? 1.8 : 2.3 })).technique);
    expect([...seen]).toEqual([first]);
    const drawn = readyFrames(chooser, 20, scene({ coverage: 10 }));
    expect(drawn[0]).toBe(first);
    expect(drawn.indexOf('clustered-deferred')).toBe(7);
    expect(drawn.at(-1)).toBe('clustered-deferred');
  });

  it('keeps to its choice a little past the bound, on either side, until the other was best for long', () => {
    for (const [from, to] of [
      [1.6, 2.4],
      [2.4, 1.6],
    ]) {
      const chooser = new TechniqueChooser();
      const first = chooser.choose(scene({ coverage: from })).technique;
      const { technique } = new TechniqueChooser().choose(scene({ coverage: to }));
      expect(technique).not.toBe(first);
      expect(new Set(readyFrames(chooser, 100, scene({ coverage: to })))).toEqual(new Set([first]));
      frames(chooser, 1, scene({ coverage: from }));
      expect(new Set(readyFrames(chooser, 120, scene({ coverage: to }))), 'counted anew').toEqual(new Set([first]));
      expect(readyFrames(chooser, 20, scene({ coverage: to })).at(-1)).toBe(technique);
    }
  });

  it('has the next technique made ready where that is possible, and keeps to the old one until it is', () => {
    const chooser = new TechniqueChooser();
    frames(chooser, 20, few);
    expect(chooser.next).toBeNull();
    frames(chooser, 7, many);
    expect(chooser.next, 'patience').toBeNull();
    expect(new Set(frames(chooser, 30, many))).toEqual(new Set(['forward-single-pass']));
    expect(chooser.next?.technique).toBe('clustered-deferred');
    const preparation = { ready: false };
    chooser.preparation = preparation;
    expect(chooser.choose(many).technique, 'not yet ready').toBe('forward-single-pass');
    expect(chooser.preparation).toBe(preparation);
    preparation.ready = true;
    expect(chooser.choose(many).technique).toBe('clustered-deferred');
    expect(chooser.next).toBeNull();
    expect(chooser.preparation).toBeNull();
  });

  it('drops what it had made ready when the old choice is good again, or another is better', () => {
    const chooser = new TechniqueChooser();
    const small = scene({ bounded: 120, coverage: 10 });
    frames(chooser, 20, few);
    frames(chooser, 8, many);
    chooser.preparation = { ready: true };
    expect(frames(chooser, 1, few)).toEqual(['forward-single-pass']);
    expect(chooser.next).toBeNull();
    frames(chooser, 8, many);
    expect(chooser.preparation, 'begins anew').toBeNull();
    chooser.preparation = { ready: true };
    expect(frames(chooser, 1, small)).toEqual(['forward-single-pass']);
    expect(chooser.next?.technique).toBe('tiled-deferred');
    expect(chooser.preparation).toBeNull();
    chooser.preparation = { ready: true };
    expect(frames(chooser, 1, small)).toEqual(['tiled-deferred']);
  });

  it('waits for nothing where the old technique cannot draw what is asked', () => {
    const chooser = new TechniqueChooser();
    frames(chooser, 20, few);
    expect(chooser.choose({ ...few, surfaces: true }).technique).toBe('clustered-deferred');
    expect(chooser.choose({ ...few, floatTargets: false }).technique).toBe('forward-single-pass');
  });

  it('waits as ever where an effect works on a G-buffer that the device cannot have', () => {
    const chooser = new TechniqueChooser();
    frames(chooser, 20, { ...few, surfaces: true, floatTargets: false });
    const drawn = readyFrames(chooser, 8, { ...many, surfaces: true, floatTargets: false });
    expect(drawn.indexOf('clustered-forward')).toBe(7);
  });

  it('does not jump in a scene that has been drawn for a while, however far behind the bound is', () => {
    const chooser = new TechniqueChooser();
    frames(chooser, 20, few);
    expect(readyFrames(chooser, 8, many).indexOf('clustered-deferred')).toBe(7);
    expect(readyFrames(chooser, 8, few).indexOf('forward-single-pass'), 'and back').toBe(7);
  });

  it('follows at once where the bound is far behind and the scene is new, as when its lights come', () => {
    const chooser = new TechniqueChooser();
    expect(chooser.choose(scene({ bounded: 0, everywhere: 0 })).technique).toBe('forward-single-pass');
    expect(chooser.choose(scene({ bounded: 50, coverage: 30 })).technique).toBe('clustered-deferred');
    expect(chooser.choose(scene({ bounded: 2, everywhere: 0, coverage: 0.1 })).technique).toBe('forward-single-pass');
  });

  it('is new for its first frames, and follows at once only what is far from the bound', () => {
    for (const [drawn, far] of [
      [8, 'clustered-deferred'],
      [9, 'forward-single-pass'],
    ] as const) {
      const chooser = new TechniqueChooser();
      frames(chooser, drawn, few);
      expect(chooser.choose(many).technique, `after ${drawn} frames`).toBe(far);
    }
    const chooser = new TechniqueChooser();
    chooser.choose(scene({ coverage: 1 }));
    expect(chooser.choose(scene({ coverage: 10 })).technique, 'not so far').toBe('clustered-forward');
  });

  it('says why', () => {
    expect(new TechniqueChooser().choose(scene({ coverage: 20 })).reason).toContain('many lights over a pixel');
  });
});
