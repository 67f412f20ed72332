import { formatCount, formatTime, t, tCount } from '@farol/editing';
import { type ReactNode, useCallback, useEffect } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { usePoll } from '../../ui/usePoll';
import './status.css';

/** Updates of the statistics per second. */
const RATE = 4;

/** File and selection, messages about drafts, and statistics of the last frame. */
export function StatusBar(): ReactNode {
  const { document, viewport, commands, file, fileChanged, drafts, phones, notices } = useEditor();
  useSignal(document.selection.changed);
  useSignal(document.structure);
  useSignal(commands.changed);
  useSignal(fileChanged);
  useSignal(drafts.changed);
  useSignal(phones.changed);
  const { problem } = drafts;
  const name = file.name ?? document.scene.name;
  useEffect(() => {
    window.document.title = `${name} – Farol`;
  }, [name]);
  const selected = document.selection.ids.length;
  const rate = usePoll(
    useCallback(() => {
      const frames = viewport.statistics.rate(performance.now());
      return frames === null ? t('at rest') : `${formatCount(frames)} FPS`;
    }, [viewport]),
    RATE,
  );
  const counts = usePoll(
    useCallback(() => {
      const { lights, drawCalls, triangles } = viewport.farol.info;
      const shown =
        lights.visible === lights.total
          ? `${lights.total}`
          : t('{visible} of {total}', { visible: lights.visible, total: lights.total });
      return [
        tCount(lights.total, '{shown} light', '{shown} lights', { shown }),
        tCount(drawCalls, '{shown} draw', '{shown} draws', { shown: formatCount(drawCalls) }),
        tCount(triangles, '{shown} triangle', '{shown} triangles', { shown: formatCount(triangles, true) }),
      ].join('\n');
    }, [viewport]),
    RATE,
  );
  const passes = usePoll(
    useCallback(() => {
      const { info } = viewport.farol;
      const onGpu = info.gpuMs !== null;
      const times = info.passes
        .map(({ name, cpuMs, gpuMs }) => ({ name, time: (onGpu ? (gpuMs ?? 0) : cpuMs).toFixed(2) }))
        .filter(({ time }) => time !== '0.00')
        .map(({ name, time }) => `${name} ${time}`);
      const total = onGpu ? info.gpuMs! : info.cpuMs;
      return `${onGpu ? 'GPU' : 'CPU'} ${total.toFixed(2)} ms\n${times.join('\n')}`;
    }, [viewport]),
    RATE,
  );
  const [total, ...each] = passes.split('\n').filter(Boolean);
  return (
    <footer className="status" aria-label={t('Status')}>
      <span className="status-file">
        {name}
        {commands.isDirty && <span className="dirty" role="img" title={t('Not saved')} aria-label={t('not saved')} />}
      </span>
      {problem !== null && (
        <button
          type="button"
          className="status-drafts"
          title={problem}
          onClick={() => notices.show('warning', problem)}
        >
          <Icon name="warning" size={12} />
          {drafts.since === null ? t('no drafts') : t('no drafts since {time}', { time: formatTime(drafts.since) })}
        </button>
      )}
      <span className="dim">
        {selected === 0 ? t('nothing selected') : tCount(selected, '{count} selected##one', '{count} selected')}
      </span>
      {phones.text && <span>{phones.text}</span>}
      <span className="status-space" />
      <span className="status-passes" title={t('Time of each pass of the last frame (ms)')}>
        {each.map((pass, i) => (
          <span key={i}>{pass}</span>
        ))}
      </span>
      <span>{total}</span>
      {counts.split('\n').map((count) => (
        <span key={count}>{count}</span>
      ))}
      <span className="status-rate">{rate}</span>
    </footer>
  );
}
