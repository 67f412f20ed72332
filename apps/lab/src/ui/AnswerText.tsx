import { t } from '@farol/editing';
import type { LabRun } from '../results/LabRun';
import { answerOf, FEW, MANY } from '../words/answerOf';
import { deviceName } from '../words/device';
import { competitorWord } from '../words/names';

/** The result of the displayed run in large type: who is fastest, in how many cases, with few and with many lights. */
export function AnswerText({ run, isReference }: { run: LabRun; isReference: boolean }) {
  const answer = answerOf(run);
  if (answer === null) return null;
  const { best, wins, cases, few, many } = answer;
  const device = deviceName(run.surroundings.device);
  return (
    <div class="answer" role="status">
      <p class="dim">
        {isReference ? t('On {device} (a reference, not your machine):', { device }) : t('On {device}:', { device })}
      </p>
      <p class="answer-name">{competitorWord(best)}</p>
      <p>
        {t('Fastest, or as fast as the fastest, in {wins} of {cases} cases.', { wins, cases })}{' '}
        {few !== null &&
          many !== null &&
          t('With up to {few} lights: {first}; with {many} or more: {second}.', {
            ...{ few: FEW, many: MANY, first: competitorWord(few), second: competitorWord(many) },
          })}
      </p>
    </div>
  );
}
