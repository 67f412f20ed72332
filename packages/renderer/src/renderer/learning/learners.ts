import { graphicsDevice } from '../../gpu/graphicsDevice';
import { LearntChoices, type Storage } from './LearntChoices';
import { type LearntChoice, readVerdict, TechniqueLearner } from './TechniqueLearner';

/** Learners by GPU, shared by all renderers of a page. */
const learners = new Map<string, TechniqueLearner>();

/** Learner of the context's GPU, with its stored verdicts. */
export function learnerOf(gl: WebGL2RenderingContext): TechniqueLearner {
  const gpu = graphicsDevice(gl);
  let learner = learners.get(gpu);
  if (learner === undefined)
    learners.set(gpu, (learner = new TechniqueLearner(new LearntChoices(gpu, storageOfPage()))));
  return learner;
}

/** Deletes the verdicts on all GPUs, stored or not. */
export function clearLearnt(): void {
  for (const learner of learners.values()) learner.clear();
  new LearntChoices('', storageOfPage()).clear();
}

/** All verdicts learnt, on all GPUs of this browser. */
export function learntChoices(): LearntChoice[] {
  const [learner] = learners.values();
  const choices = learner?.learnt ?? new LearntChoices('', storageOfPage());
  return choices.all().map((verdict) => readVerdict(...verdict));
}

/** Storage of the page; null where it is forbidden. */
function storageOfPage(): Storage | null {
  try {
    return globalThis.localStorage ?? null;
  } catch {
    return null;
  }
}
