import { BufferTarget, canEncodeVideo, CanvasSource, Mp4OutputFormat, Output, Quality, WebMOutputFormat } from "mediabunny";
import type { VideoCodec } from "mediabunny";
import type { Size } from "../view/size";
import { bitsPerSecond, LARGEST_BYTES } from "./choice";
import type { Format } from "./choice";
import { words } from "./words";

/** Codecs of each format, the preferred first. */
const CODECS: Record<Format, readonly VideoCodec[]> = { webm: ["vp9", "vp8", "av1"], mp4: ["avc", "hevc"] };

/** Whether this page may encode films: a browser without WebCodecs, or a page without a secure connection, may not. */
export const canEncode = () => typeof VideoEncoder === "function";

/** Returns the codec with which the browser encodes a format in a size; null if there is none. */
export async function codecOf(format: Format, size: Size, frames_per_s: number): Promise<VideoCodec | null> {
  if (!canEncode()) return null;
  for (const codec of CODECS[format]) if (await canEncodeVideo(codec, { ...size, frameRate: frames_per_s, quality: qualityOf(size, frames_per_s) })) return codec;
  return null;
}

const qualityOf = (size: Size, frames_per_s: number) => new Quality({ bitrate: bitsPerSecond(size, frames_per_s) });

/** Encodes the frames of a film from a canvas; only encoded frames are kept in memory. */
export class Encoder {
  private bytes = 0;
  private readonly source: CanvasSource;

  private constructor(
    private readonly output: Output<WebMOutputFormat | Mp4OutputFormat, BufferTarget>,
    canvas: HTMLCanvasElement,
    codec: VideoCodec,
    private readonly frames_per_s: number,
  ) {
    const onEncodedPacket = ({ byteLength }: { byteLength: number }) => void (this.bytes += byteLength);
    this.source = new CanvasSource(canvas, { codec, quality: qualityOf(canvas, frames_per_s), onEncodedPacket });
    output.addVideoTrack(this.source, { frameRate: frames_per_s });
  }

  /** Begins a film; throws a fault if the browser does not encode this format in this size. */
  static async begin(canvas: HTMLCanvasElement, format: Format, frames_per_s: number): Promise<Encoder> {
    const codec = await codecOf(format, canvas, frames_per_s);
    if (!codec) throw { kind: "setting", message: words.not_encoded(format, canvas.width, canvas.height) };
    const output = new Output({ format: format === "mp4" ? new Mp4OutputFormat() : new WebMOutputFormat(), target: new BufferTarget() });
    const encoder = new Encoder(output, canvas, codec, frames_per_s);
    await output.start();
    return encoder;
  }

  /** Encodes what the canvas shows as a frame; resolves when the next one may come. */
  async add(frame: number): Promise<void> {
    await this.source.add(frame / this.frames_per_s, 1 / this.frames_per_s);
    if (this.bytes > LARGEST_BYTES) throw { kind: "setting", message: words.too_many_bytes(LARGEST_BYTES / 1e6) };
  }

  async finish(): Promise<Blob> {
    await this.output.finalize();
    return new Blob([this.output.target.buffer!], { type: this.output.format.mimeType });
  }

  async cancel(): Promise<void> {
    await this.output.cancel();
  }
}
