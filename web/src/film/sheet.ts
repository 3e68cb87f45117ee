import { fixed } from "../app/format";
import type { Moment, Recording } from "../app/recording/recording";
import { styleOf } from "../plots/chart";
import type { Size } from "../view/size";
import type { PictureChoice } from "./choice";
import { CAPTION, layoutOf } from "./layout";
import type { Layout } from "./layout";
import { FilmedPlot } from "./plot";
import type { FilmedLines } from "./plot";

/** Text sizes of the caption, pixels of 1280x720, and the largest number of rows of the user's text. */
const PX = { title: 17, text: 15 };
const MOST_ROWS = 3;
const TIME_DECIMALS = 2;

/** Content of all pictures of a film. */
export interface SheetContent {
  choice: PictureChoice;
  /** Title of the run. */
  title: string;
  plots: readonly FilmedLines[];
  /** Times of the plots, s. */
  range_s: readonly [number, number];
  recording: Recording;
}

/** A picture of a film: the ship, the plots beside or below her, and the caption at the foot. */
export class Sheet {
  readonly canvas = document.createElement("canvas");
  private readonly pen: CanvasRenderingContext2D;
  private readonly style = styleOf();
  private readonly layout: Layout;
  private readonly rows: string[];
  private readonly plots: FilmedPlot[];

  constructor(private readonly content: SheetContent) {
    const { choice, plots, range_s, recording } = content;
    const { size, hasPlots, caption } = choice;
    [this.canvas.width, this.canvas.height] = [size.width, size.height];
    this.pen = this.canvas.getContext("2d", { alpha: false })!;
    const shown = hasPlots ? plots : [];
    const { scale } = layoutOf(size, shown.length, 0);
    this.rows = this.inRows(caption, scale, size.width);
    this.layout = layoutOf(size, shown.length, this.rows.length);
    this.plots = this.layout.plots.map((part, i) => new FilmedPlot(shown[i], part, scale, range_s, recording));
  }

  /** Size of the picture of the ship. */
  get ship(): Size {
    return this.layout.ship;
  }

  /** Draws the picture of a moment with the picture of the ship. */
  draw(ship: HTMLCanvasElement, moment: Moment): void {
    const { left, top } = this.layout.ship;
    this.pen.fillStyle = this.style.colour("surface");
    this.pen.fillRect(0, 0, this.canvas.width, this.canvas.height);
    this.pen.drawImage(ship, left, top);
    for (const plot of this.plots) plot.draw(this.pen, moment.time_s, moment.row);
    this.drawCaption(moment.time_s);
  }

  /** Returns the picture as a PNG file. */
  png(): Promise<Blob | null> {
    return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
  }

  private drawCaption(time_s: number): void {
    const { pen } = this;
    const { caption, scale } = this.layout;
    const margin = scale * CAPTION.margin;
    const y = caption.top + margin / 2;
    pen.textBaseline = "top";
    const time = `${fixed(time_s, TIME_DECIMALS)} s`;
    this.write(PX.text, "ink", 400);
    pen.textAlign = "right";
    const room = pen.measureText(time).width;
    pen.fillText(time, caption.width - margin, y + scale);
    pen.textAlign = "left";
    this.write(PX.title, "ink", 700);
    pen.fillText(this.content.title, margin, y, Math.max(1, caption.width - 3 * margin - room));
    this.write(PX.text, "ink", 400);
    this.rows.forEach((row, i) => pen.fillText(row, margin, y + scale * (CAPTION.title + i * CAPTION.row), caption.width - 2 * margin));
  }

  private write(px: number, colour: string, weight: number): void {
    this.pen.font = `${weight} ${this.layout.scale * px}px ${this.style.colour("font")}`;
    this.pen.fillStyle = this.style.colour(colour);
  }

  /** Divides the user's text into rows; words beyond the last row are on it, narrowed. */
  private inRows(text: string, scale: number, width: number): string[] {
    this.pen.font = `400 ${scale * PX.text}px ${this.style.colour("font")}`;
    const rows: string[] = [];
    for (const word of text.split(/\s+/).filter((one) => one !== "")) {
      const longer = `${rows.at(-1) ?? ""} ${word}`.trim();
      const isFull = this.pen.measureText(longer).width > width - 2 * scale * CAPTION.margin;
      if (rows.length === 0 || (isFull && rows.length < MOST_ROWS)) rows.push(word);
      else rows[rows.length - 1] = longer;
    }
    return rows;
  }
}
