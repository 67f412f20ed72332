import type { SoundSize } from './SoundSize';

/** Uncompressed formats: PCM, floats, A-law, µ-law, extensible. */
const WHOLE = new Set([1, 3, 6, 7, 0xfffe]);
/** Minimum bits of a sample in packed formats (ADPCM). */
const PACKED = 2;

/** Size of a WAV; a data length beyond the end of the file is cut. @see RIFF, WAVEFORMATEX */
export function wavSize(view: DataView): SoundSize | null {
  let channels = 0;
  let rate = 0;
  let bits = 0;
  for (let at = 12; at + 8 <= view.byteLength;) {
    const name = view.getUint32(at);
    const said = view.getUint32(at + 4, true);
    const length = Math.min(said, view.byteLength - at - 8);
    // 'fmt '
    if (name === 0x666d7420 && length >= 16) {
      channels = view.getUint16(at + 10, true);
      rate = view.getUint32(at + 12, true);
      bits = WHOLE.has(view.getUint16(at + 8, true)) ? view.getUint16(at + 22, true) || 8 : PACKED;
    }
    // 'data'
    if (name === 0x64617461) {
      return channels > 0 && rate > 0 ? { seconds: (length * 8) / (bits * channels * rate), channels, rate } : null;
    }
    at += 8 + length + (length % 2);
  }
  return null;
}
