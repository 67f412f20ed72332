import type { EditorDocument } from '../EditorDocument';
import { below, pick, type Random } from './random';

/** Plays, steps or stops, and advances the time. */
export function randomSimulation(random: Random, document: EditorDocument): void {
  const { simulation } = document;
  const act = below(random, 4);
  if (act === 0) simulation.play();
  else if (act === 1) simulation.step();
  else if (act === 2) simulation.stop();
  simulation.advance(random() * 0.2);
}

/** Keeps edits made while the scene played: one value, or all. */
export function randomKeep(random: Random, { playEdits, scene }: EditorDocument): void {
  const change = pick(random, playEdits.changes);
  const isThere = ({ owner }: typeof change): boolean => !('isAttached' in owner) || owner.scene === scene;
  if (change && random() < 0.3) {
    if (isThere(change)) playEdits.keep(change);
  } else if (playEdits.canKeepAll || playEdits.changes.every(isThere)) playEdits.keepAll();
}
