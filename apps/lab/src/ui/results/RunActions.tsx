import { t } from '@farol/editing';
import type { ComponentChildren } from 'preact';
import { useMemo } from 'preact/hooks';
import { usesOwnScene } from '../../own/ownPreset';
import type { Configuration } from '../../plan/Configuration';
import { ExportMenu } from '../../results/ExportMenu';
import type { LabRun } from '../../results/LabRun';
import { linkOf } from '../../results/link';
import { configurationOfPlan } from '../support/configurationOfPlan';
import { referenceFor } from '../support/useShownRun';
import { messageOf } from '../../run/messageOf';

interface RunActionsProps {
  run: LabRun;
  isReference: boolean;
  hasOwnScene: boolean;
  onRename(name: string): void;
  onMeasure(configuration: Configuration): void;
  onCompare(reference: LabRun): void;
  onProblem(problem: string): void;
  /** Control that opens another run. */
  choice: ComponentChildren;
}

/** Controls of a run: rename it, measure it again, compare it with a reference, export it. */
export function RunActions(props: RunActionsProps) {
  const { run, isReference, hasOwnScene, onRename, onMeasure, onCompare, onProblem, choice } = props;
  const configuration = useMemo(() => configurationOfPlan(run.plan), [run.plan]);
  const reference = referenceFor(run);
  const isOwn = configuration !== null && usesOwnScene(configuration);
  const link = configuration && !isOwn && new URL(linkOf(configuration), location.href).href;
  const compare = async (): Promise<void> => {
    try {
      if (reference) onCompare(await reference.read());
    } catch (error) {
      onProblem(messageOf(error));
    }
  };
  return (
    <div class="run-actions">
      {choice}
      {!isReference && (
        <label class="inline-field">
          {t('Name')}
          <input
            key={run.id}
            type="text"
            class="run-title"
            maxLength={200}
            placeholder={t(run.plan.label)}
            defaultValue={run.name}
            onChange={({ currentTarget }) => onRename(currentTarget.value.trim())}
          />
        </label>
      )}
      {configuration && (!isOwn || hasOwnScene) && (
        <button type="button" onClick={() => onMeasure(configuration)}>
          {isReference ? t('Measure the same here') : t('Measure again')}
        </button>
      )}
      {reference && (
        <button type="button" onClick={() => void compare()}>
          {t('Compare with the reference')}
        </button>
      )}
      <ExportMenu run={run} link={link || null} />
    </div>
  );
}
