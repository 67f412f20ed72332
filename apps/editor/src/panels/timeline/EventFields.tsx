import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { clipName } from '../../model/timeline/clipEdits';
import { changeEvent } from '../../model/timeline/editEvents';
import { NumberInput } from '../../ui/NumberInput';
import { TextInput } from '../../ui/TextInput';
import { eventValueText, readEventValue } from './eventValue';
import type { TimelineView } from './TimelineView';

/** Time, method and value of the selected event. */
export function EventFields({ view }: { view: TimelineView }): ReactNode {
  const { timeline } = view;
  const { data, selection, clip } = timeline;
  const [place] = selection.events;
  const event = data.events[place];
  if (selection.events.length !== 1 || !event || !clip) return null;
  const change = (next: Partial<typeof event>): void => {
    const edit = changeEvent(data, place, next);
    const label = t('Changed an event of {name}', { name: clipName(clip) });
    timeline.edit(label, { data: edit.data, selected: new Set() }, edit.places);
  };
  return (
    <div className="timeline-fields" role="group" aria-label={t('Selected event')}>
      <EventTime view={view} time={event.time} onChange={(time) => change({ time })} />
      <div className="timeline-text">
        <TextInput
          value={event.method}
          label={t('Method')}
          description={t('Called on every component that has it, of the object and of all below it.')}
          onCommit={(method) => method.trim() !== '' && change({ method: method.trim() })}
        />
      </div>
      <div className="timeline-text">
        <TextInput
          value={eventValueText(event.value)}
          label={t('Value')}
          description={t('Argument of the method: a number, yes or no, or text; none when empty.')}
          onCommit={(text) => change({ value: readEventValue(text) })}
        />
      </div>
    </div>
  );
}

/** Field for an event's time; one step of history when typing ends. */
function EventTime({
  view,
  time,
  onChange,
}: {
  view: TimelineView;
  time: number;
  onChange(time: number): void;
}): ReactNode {
  const { timeline, unit } = view;
  const rate = unit === 'frames' ? timeline.frameRate : 1;
  let next = time;
  return (
    <div className="timeline-time">
      <NumberInput
        value={time * rate}
        min={0}
        step={unit === 'frames' ? 1 : 1 / timeline.frameRate}
        unit={unit === 'frames' ? undefined : 's'}
        digits="short"
        label={t('Time of the event')}
        onPreview={(shown) => {
          next = shown / rate;
        }}
        onCommit={() => next !== time && onChange(next)}
      />
    </div>
  );
}
