import { t } from '@farol/editing';
import type { LabRun } from '../../results/LabRun';
import { referenceRuns } from '../../results/referenceRuns';
import type { RunInfo, RunStore } from '../../results/RunStore';
import { useRuns } from '../../results/useRuns';
import { deviceName } from '../../words/device';
import { formatDate } from '../../words/format';
import { Select } from '../Select';
import { messageOf } from '../../run/messageOf';

interface RunChoiceProps {
  store: RunStore;
  run: LabRun | null;
  onOpen(run: LabRun): void;
  onProblem(problem: string): void;
}

/** Select that opens a kept run or a reference. */
export function RunChoice({ store, run, onOpen, onProblem }: RunChoiceProps) {
  const { runs } = useRuns(store);
  const kept = runs ?? [];
  const references = referenceRuns.map(({ info }) => info);
  const all = [...kept, ...references];
  if (all.length < 2) return null;
  const open = async (id: string): Promise<void> => {
    if (id === '') return;
    try {
      const reference = referenceRuns.find(({ info }) => info.id === id);
      onOpen(await (reference ? reference.read() : store.open(id)));
    } catch (error) {
      onProblem(messageOf(error));
    }
  };
  const isListed = run !== null && all.some(({ id }) => id === run.id);
  return (
    <Select
      class="inline-field"
      label={t('Show')}
      value={isListed ? run.id : ''}
      options={[
        ...(isListed ? [] : [['', run ? run.name || t(run.plan.label) : t('None')] as const]),
        ...all.map((info, index) => [info.id, infoText(info, index >= kept.length)] as const),
      ]}
      onChange={(id) => void open(id)}
    />
  );
}

function infoText({ name, label, date, device }: RunInfo, isReference: boolean): string {
  const what = name || t(label);
  return isReference
    ? t('Reference: {name}', { name: `${what}, ${deviceName(device)}` })
    : `${what}, ${formatDate(date)}`;
}
