import type { SoundSize } from './SoundSize';

/** Container boxes that lead to the samples of a track, in whole or fragmented files. */
const HOLDERS = new Set(['moov', 'trak', 'mdia', 'minf', 'stbl', 'moof', 'traf']);
/** Audio samples per AAC sample of an MP4; with SBR twice as many, at twice the rate. */
const SAMPLES = 1024;

/**
 * Size of AAC in an MP4: the greater of the length in the header and that of the samples.
 * @see ISO/IEC 14496-12
 */
export function mp4Size(view: DataView): SoundSize | null {
  let count = 0;
  let said = 0;
  let rate = 0;
  let isOther = false;
  const tag = (at: number): string => String.fromCharCode(...[0, 1, 2, 3].map((i) => view.getUint8(at + i)));
  /** @param depth - nesting depth of the box; relevant boxes are at most seven deep */
  const visit = (from: number, to: number, depth: number): void => {
    for (let at = from; at + 8 <= to;) {
      const short = view.getUint32(at);
      const head = short === 1 ? 16 : 8;
      const length = short === 1 && at + 16 <= to ? Number(view.getBigUint64(at + 8)) : short === 0 ? to - at : short;
      if (length < head) return;
      const end = Math.min(to, at + length);
      const name = tag(at + 4);
      const data = at + head;
      if (HOLDERS.has(name) && depth < 8) visit(data, end, depth + 1);
      else if (name === 'mdhd' && data + 32 <= end) {
        const isLong = view.getUint8(data) === 1;
        const duration = isLong ? Number(view.getBigUint64(data + 24)) : view.getUint32(data + 16);
        // all bits set: the duration is not known
        if (duration < 0xffffffff || isLong)
          said = Math.max(said, duration / Math.max(1, view.getUint32(data + (isLong ? 20 : 12))));
      } else if (name === 'stsd' && data + 44 <= end) {
        isOther ||= tag(data + 12) !== 'mp4a';
        rate = Math.max(rate, view.getUint16(data + 40));
      } else if (name === 'stsz' && data + 12 <= end) count += Math.min(view.byteLength, view.getUint32(data + 8));
      else if (name === 'trun' && data + 8 <= end) count += Math.min(view.byteLength, view.getUint32(data + 4));
      at += length;
    }
  };
  visit(0, view.byteLength, 0);
  if (isOther || rate === 0) return null;
  return { seconds: Math.max(said < 1e9 ? said : 0, (count * SAMPLES) / rate), channels: 2, rate };
}
