import { t } from '@farol/editing';
import type { LabRun } from '../results/LabRun';
import { AnswerText } from './AnswerText';
import { DeviceNote } from './DeviceNote';
import type { StageState } from './support/useStage';

interface HeroProps {
  /** Displayed run; null while there is none. */
  run: LabRun | null;
  /** Whether the displayed run is a reference of the repository. */
  isReference: boolean;
  stage: StageState;
  isBusy: boolean;
  onMeasure(): void;
}

/** Introduction of the Lab, and the button of the quick run. */
export function Hero({ run, isReference, stage, isBusy, onMeasure }: HeroProps) {
  return (
    <section class="hero" aria-labelledby="title">
      <div class="hero-words">
        <h1 id="title">{t('Which way of lighting is fastest on your machine?')}</h1>
        {run && <AnswerText run={run} isReference={isReference} />}
        <p>
          {t(
            'The Lab draws the same scenes by eleven techniques of Farol, by three.js and by other engines, in turns, and shows which is fastest where.',
          )}
        </p>
        <button type="button" class="primary large" disabled={isBusy || stage.device === null} onClick={onMeasure}>
          {t('Measure this machine (90\u00a0s)')}
        </button>
      </div>
      <DeviceNote {...stage} />
    </section>
  );
}
