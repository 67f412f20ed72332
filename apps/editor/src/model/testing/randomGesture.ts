import type { EditorDocument } from '../EditorDocument';
import { below, objectsOf, pick, type Random } from './random';
import { randomCommand } from './randomCommand';
import { randomEdit } from './randomEdit';

/** A drag of several previews, committed or discarded; sometimes of different commands. */
export function randomGesture(random: Random, document: EditorDocument): void {
  const gesture = document.commands.begin();
  const owner = pick(random, objectsOf(document.scene))?.transform ?? document.scene.settings;
  for (let i = below(random, 4); i >= 0; i--) {
    if (random() < 0.7) gesture.preview(randomEdit(random, document, owner));
    else {
      gesture.reset();
      gesture.preview(randomCommand(random, document));
    }
  }
  if (random() < 0.6) gesture.commit();
  else gesture.discard();
}
