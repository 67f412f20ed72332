import { builtinComponents, ComponentRegistry, createRandom } from '@farol/engine';
import { loadBakeCode } from '@farol/engine/bake';
import { serialize } from '@farol/engine/files';
import { extent, isWhole } from '@farol/tools/extent';
import { beforeAll, expect, it } from 'vitest';
import { EditorDocument } from './EditorDocument';
import { litBy } from './testing/randomBakeCommand';
import { randomCommand } from './testing/randomCommand';
import { randomGesture } from './testing/randomGesture';
import { randomScene } from './testing/randomScene';
import { loadSurfaces } from './testing/randomSurfaceCommand';
import { scriptsInNode } from './testing/scriptsInNode';
import { randomKeep, randomSimulation } from './testing/randomSimulation';

// loaded beforehand, so that decals need not fetch it after the last step
beforeAll(() => import('@farol/renderer/decals'));
beforeAll(loadBakeCode);
beforeAll(loadSurfaces);

/** State of a document as text: the scene file, available assets, and lighting by baked light. */
const stateOf = ({ scene, assets }: EditorDocument): string =>
  `${JSON.stringify(serialize(scene))} ${assets.list().toSorted().join()} ${litBy(scene)}`;

const STEPS = { slice: 1500, verify: 2500, long: 25_000 }[extent];

it.each(isWhole ? [1, 2, 3, 4] : [1])(
  'undoes and redoes random edits exactly, seed %i',
  async (seed) => {
    const random = createRandom(seed);
    const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
    const document = new EditorDocument(undefined, registry, scriptsInNode());
    document.open(randomScene(random, document));
    const { commands } = document;
    /** State after each number of steps that the history still holds. */
    const states = [stateOf(document)];
    let steps = 0;
    for (let i = 0; i < STEPS; i++) {
      const act = random();
      const last = commands.last;
      let isEdit = false;
      if (act < 0.15) steps -= commands.undo() ? 1 : 0;
      else if (act < 0.25) steps += commands.redo() ? 1 : 0;
      else if (act < 0.35) {
        randomSimulation(random, document);
        // stopping undoes the steps done since the scene began to play
        const taken = steps - commands.history.length;
        if (taken > 0) states.splice((steps -= taken) + 1);
      } else {
        if (act < 0.5) randomGesture(random, document);
        else if (act < 0.53) randomKeep(random, document);
        else commands.run(randomCommand(random, document));
        isEdit = commands.last !== last;
        if (document.scripts.isCompiling) await document.scripts.settled();
      }
      const state = stateOf(document);
      if (isEdit) {
        states.splice(++steps, Infinity, state);
        // the history is limited: the oldest steps are forgotten
        while (steps > commands.history.length) {
          states.shift();
          steps--;
        }
      }
      if (commands.history.length !== steps || state !== states[steps]) {
        expect.fail(`step ${i}: not what it was after '${commands.undoLabel}', before '${commands.redoLabel}'`);
      }
    }
    document.simulation.stop();
    if (commands.history.length < steps) states.splice((steps = commands.history.length) + 1);
    // long texts are compared by ===, which is faster than expect
    const isAt = (step: number): boolean => stateOf(document) === states[step];
    while (commands.undo()) if (!isAt(--steps)) expect.fail(`not what it was before '${commands.redoLabel}'`);
    expect(steps).toBe(0);
    while (commands.redo()) if (!isAt(++steps)) expect.fail(`not what it was after '${commands.undoLabel}'`);
    expect(steps).toBe(states.length - 1);
    // fewer than were run, since stopping undoes steps made while the scene played
    expect(steps).toBeGreaterThan(100);
    for (const id of document.selection.ids) expect(document.scene.findById(id)).not.toBeNull();
  },
  3_600_000,
);
