// @ts-check
// The teacher's notes: what they say of these very data.

import { byId, element, patch } from "../dom.js";
import { kindText, shortList } from "../model/format.js";
import { numberText, said, t } from "../texts.js";

/**
 * What stands in the places of the notes.
 * @param {Lesson} lesson
 * @returns {TextValues}
 */
export function teacherValues(lesson) {
  const { fit, sweep } = lesson.data;
  const rows = lesson.readings.map(({ row }) => row).filter((row) => lesson.matters.get(row));
  const isFactor = lesson.epsilon === null;
  const least = isFactor ? sweep?.least : fit.minimax?.epsilon;
  return {
    readings: lesson.readings.length,
    planes: lesson.halfPlanes.length,
    set: kindText(lesson.fps.kind, lesson.fps.vertices.length),
    matter: rows.length === 0 ? t("teacher.ask-none") : shortList(rows),
    least: least ? `${isFactor ? "s" : "ε"} = ${numberText(least.decimal)}` : t("teacher.ask-no-least"),
  };
}

/**
 * The questions of the page with their answers, for whoever teaches.
 * @param {Lesson} lesson
 */
export function drawTeacher(lesson) {
  const answers = lesson.data.questions.flatMap(({ question, answer }) => [
    element("dt", {}, said(question)),
    element("dd", {}, said(answer)),
  ]);
  patch(byId("teacher-answers"), answers);
}
