import { t } from '@farol/editing';
import { type ReactNode, useCallback } from 'react';
import { useEditor } from '../../ui/EditorContext';
import { usePoll } from '../../ui/usePoll';

const ms = (value: number | null): string => (value === null ? '–' : value.toFixed(value < 10 ? 2 : 1));

/** Time of each effect in the last frame: on the CPU, and on the GPU where it can be measured. */
export function EffectCosts(): ReactNode {
  const { viewport } = useEditor();
  const rows = usePoll(
    useCallback(() => {
      const { info, effects } = viewport.farol;
      // an effect that is drawn several times in a frame has one entry of `info.passes`
      const passes = new Map(info.passes.map((pass) => [pass.name, pass]));
      return effects
        .flatMap(({ name }) => passes.get(name) ?? [])
        .map(({ name, cpuMs, gpuMs }) => [name, ms(cpuMs), ms(gpuMs)].join('\t'))
        .join('\n');
    }, [viewport]),
    4,
  );
  if (rows === '') return null;
  return (
    <table className="pass-table" aria-label={t('What the effects cost')}>
      <thead>
        <tr>
          <th scope="col">{t('Effect')}</th>
          <th scope="col">CPU ms</th>
          <th scope="col">GPU ms</th>
        </tr>
      </thead>
      <tbody>
        {rows.split('\n').map((row) => {
          const [name, cpu, gpu] = row.split('\t');
          return (
            <tr key={name}>
              <th scope="row">{name}</th>
              <td>{cpu}</td>
              <td>{gpu}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
